// On random triangles, fields and coats, strands are finite, rooted on their triangles, and the same in any order of
// them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "renderer/coat/strand_tile.h"
#include "renderer/strands/grow.h"
#include "renderer/strands/tile_strands.h"

namespace pelage {
namespace {

int whole(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high)); }
double between(double low, double high) { return low + (high - low) * whole(0, 1'000'001) * 1e-6; }

/// A fan of triangles around a vertex in the tile's plane, partly outside the first tile.
struct Fan {
  std::vector<glm::vec3> positions, normals, tangents;
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<FurCorner, 3>> corners;
  std::vector<glm::vec2> direction;
  std::vector<float> length, density, width, curl, clump, wetness, bare;
  std::vector<glm::vec4> colour;

  FurModel model() const { return {1, positions, normals, tangents, triangles, corners, {}, false}; }
  FurFields fields() const {
    return {direction, length, {}, {}, {density, width, curl, clump, wetness, bare, {}, colour, colour}};
  }
  StrandChunk all() const {
    StrandChunk chunk;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) chunk.push_back(i);
    return chunk;
  }
};

void add_vertex(Fan& fan, glm::dvec2 position) {
  fan.positions.emplace_back(position, 0);
  fan.normals.emplace_back(0, 0, 1), fan.tangents.emplace_back(1, 0, 0);
  const double angle = between(0, 6.3), inclination = between(0, 1);
  fan.direction.emplace_back(inclination * std::cos(angle), inclination * std::sin(angle));
  fan.length.push_back(*rc::gen::element(0.0f, 1e-6f, 0.0005f, 0.03f, 10.0f));
  for (auto* field : {&fan.density, &fan.curl, &fan.clump, &fan.wetness, &fan.bare})
    field->push_back(static_cast<float>(*rc::gen::element(0.0, 1.0, between(0, 1))));
  fan.width.push_back(static_cast<float>(between(0, 4)));
  fan.colour.emplace_back(between(0, 1), between(0, 1), between(0, 1), between(0, 1));
}

Fan make_fan() {
  Fan fan;
  const int spokes = whole(4, 12);  // enough spokes that no triangle is flipped
  const glm::dvec2 middle(between(-0.3, 0.3), between(-0.3, 0.3));
  add_vertex(fan, middle);
  for (int i = 0; i < spokes; ++i) {
    const double angle = 6.283185307179586 * (i + between(0, 0.8)) / spokes, radius = between(1e-6, 0.1);
    add_vertex(fan, middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  for (unsigned i = 0; i < static_cast<unsigned>(spokes); ++i) {
    const glm::uvec3 t(0, 1 + i, 1 + (i + 1) % static_cast<unsigned>(spokes));
    std::array<FurCorner, 3>& corners = fan.corners.emplace_back();
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)].tile_uv = glm::vec2(fan.positions[t[k]]);
      corners[static_cast<std::size_t>(k)].tile_axis = {1, 0, 0};
    }
    fan.triangles.push_back(t);
  }
  return fan;
}

Coat make_coat() {
  Coat coat;
  coat.count = whole(1, 2000), coat.tile = between(0.03, 0.3), coat.seed = static_cast<std::uint32_t>(whole(0, 100));
  coat.width_root = between(0, 0.05), coat.width_tip = between(0, 0.05);
  coat.bend = between(0, 2), coat.curl = between(0, 0.5), coat.wave = between(0, 0.5), coat.mess = between(0, 1);
  coat.clump = between(0, 1), coat.clump_size = between(0.001, 0.5), coat.wetness = between(0, 1);
  coat.length_spread = between(0, 1), coat.root_share = between(0, 1), coat.tufts.gather = between(0, 1);
  coat.lean_curve = *rc::gen::element(LeanCurve::arc, LeanCurve::root);
  coat.pattern.kind = *rc::gen::element(PatternKind::none, PatternKind::stripes, PatternKind::spots);
  coat.variation = {between(0, 1), between(0, 1), between(0, 1), between(0, 1), 0.05};
  return coat;
}

bool finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

RC_GTEST_PROP(GrowProperties, StrandsAreFiniteAndKeepToTheirTriangles, ()) {
  const Fan fan = make_fan();
  const GrowRecipe recipe{make_coat(), false, between(0.01, 1), between(1, 10)};
  const StrandSet set = Grower(fan.model(), fan.fields(), recipe).grow(fan.all());
  const std::size_t knots = static_cast<std::size_t>(set.segments) + 1;
  RC_ASSERT(set.points.size() == knots * set.count());
  RC_ASSERT(set.colours.size() == set.points.size());
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::vec3 root = set.points[i * knots].position;
    RC_ASSERT(glm::distance(root, fan.positions[0]) < 0.11f);
    RC_ASSERT(root.z == 0);
    RC_ASSERT(set.roots[i].reach > 0 && set.roots[i].reach <= 1);
    RC_ASSERT(set.roots[i].number >= 0 && set.roots[i].number <= 1);
    for (std::size_t k = 0; k < knots; ++k) {
      const StrandPoint& point = set.points[i * knots + k];
      RC_ASSERT(finite(point.position));
      RC_ASSERT(point.radius >= 1e-7f && point.radius <= 4 * 10 * 4 * 0.05f);
      RC_ASSERT(glm::distance(point.position, root) <= 2 * 2.0f * 10 + 0.1f);
    }
  }
}

RC_GTEST_PROP(GrowProperties, EachCopyFallsIntoOneTriangleOfAFan, ()) {
  const Fan fan = make_fan();
  const Coat coat = make_coat();
  const std::vector<Strand> strands = make_strands(coat);
  const TileCells cells(strands, coat.tile);
  std::vector<std::tuple<std::uint32_t, int, int>> seen;
  std::vector<TileCopy> found;
  for (const auto& corners : fan.corners) {
    const std::array<glm::dvec2, 3> triangle{corners[0].tile_uv, corners[1].tile_uv, corners[2].tile_uv};
    cells.find(triangle, found);
    for (const TileCopy& copy : found) {
      seen.emplace_back(copy.strand, copy.tiles.x, copy.tiles.y);
      const glm::dvec2 position = strands[copy.strand].root + glm::dvec2(copy.tiles) * coat.tile;
      glm::dvec2 back(0);
      for (int k = 0; k < 3; ++k) back += copy.share[k] * triangle[static_cast<std::size_t>(k)];
      RC_ASSERT(glm::distance(position, back) < 1e-9);
    }
  }
  std::sort(seen.begin(), seen.end());
  RC_ASSERT(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

/// The grid of TileCells finds the same copies as a test of each copy.
RC_GTEST_PROP(GrowProperties, NoCopyIsMissed, ()) {
  const Coat coat = make_coat();
  const std::vector<Strand> strands = make_strands(coat);
  std::array<glm::dvec2, 3> triangle;
  for (glm::dvec2& corner : triangle) corner = {between(-0.2, 0.2), between(-0.2, 0.2)};
  std::vector<TileCopy> found;
  TileCells(strands, coat.tile).find(triangle, found);
  const auto side = [&](std::size_t i, glm::dvec2 p) {
    const glm::dvec2 a = triangle[i], b = triangle[(i + 1) % 3];
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  std::size_t inside = 0;
  const int tiles = static_cast<int>(0.2 / coat.tile) + 2;
  for (const Strand& strand : strands) {
    for (int y = -tiles; y < tiles; ++y) {
      for (int x = -tiles; x < tiles; ++x) {
        const glm::dvec2 p = strand.root + glm::dvec2(x, y) * coat.tile;
        const double s[] = {side(0, p), side(1, p), side(2, p)};
        inside += (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
      }
    }
  }
  RC_ASSERT(found.size() == inside);
}

}  // namespace
}  // namespace pelage
