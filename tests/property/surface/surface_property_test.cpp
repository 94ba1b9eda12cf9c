// Meshes, patches and searches keep their contracts for random triangles.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "server/patches/patches.h"
#include "server/surface/prepare.h"
#include "server/surface/surface.h"

namespace pelage {
namespace {

/// A whole number in [low, high), over the full range even in RapidCheck's first, small cases.
int whole(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high)); }

double between(double low, double high) { return low + (high - low) * whole(0, 1'000'000) * 1e-6; }

/// Coordinates anywhere, or on a coarse grid, where vertices coincide, edges are shared and triangles have no area.
glm::dvec3 random_position(bool on_grid) {
  if (!on_grid) return {between(-1, 1), between(-1, 1), between(-1, 1)};
  const auto step = [] { return static_cast<double>(whole(-2, 3)) * 0.5; };
  const double x = step(), y = step(), z = step();
  return {x, y, z};
}

double odd_number() {
  return *rc::gen::element(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308,
                           -0.0, 1e-308);
}

RawModel soup(bool nasty) {
  RawModel raw;
  const bool on_grid = *rc::gen::arbitrary<bool>();
  const double scale = std::pow(10.0, whole(-15, 20));
  const int vertices = whole(3, 40), faces = whole(1, 60);
  for (int v = 0; v < vertices; ++v) {
    raw.positions.push_back(scale * random_position(on_grid));
    if (nasty && whole(0, 20) == 0) raw.positions.back()[v % 3] = odd_number();
  }
  for (int f = 0; f < faces; ++f) {
    const auto corners = static_cast<std::uint32_t>(nasty ? whole(1, 9) : 3);
    raw.face_sizes.push_back(corners);
    for (std::uint32_t k = 0; k < corners; ++k) {
      const bool missing = nasty && whole(0, 50) == 0;
      raw.corners.push_back(missing ? no_position : static_cast<std::uint32_t>(whole(0, vertices)));
    }
  }
  return raw;
}

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_frames(const Mesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    RC_ASSERT(is_finite(mesh.positions[v]) && is_finite(mesh.normals[v]) && is_finite(mesh.tangents[v]));
    RC_ASSERT(std::abs(glm::length(mesh.normals[v]) - 1) < 1e-5f);
    RC_ASSERT(std::abs(glm::length(mesh.tangents[v]) - 1) < 1e-5f);
    RC_ASSERT(std::abs(glm::dot(mesh.normals[v], mesh.tangents[v])) < 1e-5f);
  }
}

/// Checks that points are finite with unit axes, that every triangle is covered, and that a corner's weights sum to 1.
void check_patches(const Mesh& mesh, const PatchMap& map) {
  for (const PatchPoint& point : map.points) {
    RC_ASSERT(point.vertex < mesh.positions.size() && point.patch < map.patches);
    RC_ASSERT(std::isfinite(point.uv.x) && std::isfinite(point.uv.y));
    RC_ASSERT(point.weight >= 0 && point.weight <= 1);
    RC_ASSERT(std::abs(glm::length(point.axis) - 1) < 1e-4f);
  }
  std::vector<glm::dvec3> sums(mesh.triangles.size(), glm::dvec3(0));
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    RC_ASSERT(patch_triangle.triangle < mesh.triangles.size());
    for (int k = 0; k < 3; ++k) {
      const PatchPoint& point = map.points.at(patch_triangle.points[k]);
      RC_ASSERT(point.vertex == mesh.triangles[patch_triangle.triangle][k] && point.patch == patch_triangle.patch);
      sums[patch_triangle.triangle][k] += double{point.weight};
    }
  }
  for (const glm::dvec3& sum : sums) {
    for (int k = 0; k < 3; ++k) RC_ASSERT(std::abs(sum[k] - 1) < 1e-5);
  }
}

/// Number of edges whose two triangles have opposite windings.
std::size_t disagreeing_edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<bool>> sides;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides[std::minmax(a, b)].push_back(a < b);
    }
  }
  return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [](const auto& edge) {
    return edge.second.size() == 2 && edge.second[0] == edge.second[1];
  }));
}

std::size_t count_of(const Mesh& mesh, const std::string& code) {
  for (const Repair& repair : mesh.report.repairs) {
    if (repair.code == code) return repair.count;
  }
  return 0;
}

RC_GTEST_PROP(Prepare, AnySoupIsGroomableOrRefused, ()) {
  const RawModel raw = soup(true);
  const Result<Mesh> mesh =
      prepare(raw, {.up = Axis::plus_z, .front = Axis::minus_x, .source_is_32_bit = *rc::gen::arbitrary<bool>()});
  if (!mesh.ok()) {
    RC_ASSERT(mesh.status().code == Code::invalid);
    RC_ASSERT(mesh.status().message.size() > 10u);
    return;
  }
  check_frames(*mesh);
  RC_ASSERT(mesh->size > 0 && std::isfinite(mesh->size));
  for (const glm::uvec3& t : mesh->triangles) {
    RC_ASSERT(t.x != t.y && t.y != t.z && t.z != t.x);
    RC_ASSERT(std::max({t.x, t.y, t.z}) < mesh->positions.size());
  }
  check_patches(*mesh, lay_patches(*mesh));
}

RC_GTEST_PROP(Prepare, WindingAgreesWhereItCan, ()) {
  const Result<Mesh> mesh = prepare(soup(false));
  if (!mesh.ok()) return;
  RC_ASSERT((disagreeing_edges(*mesh) > 0) == (count_of(*mesh, "one_sided_edges") > 0));
}

RC_GTEST_PROP(Prepare, SameInputSameBits, ()) {
  const RawModel raw = soup(true);
  const Result<Mesh> a = prepare(raw);
  const Result<Mesh> b = prepare(raw);
  RC_ASSERT(a.ok() == b.ok());
  if (!a.ok()) return;
  RC_ASSERT(a->positions == b->positions && a->normals == b->normals && a->tangents == b->tangents);
  RC_ASSERT(a->triangles == b->triangles);
}

bool same_bits(const PatchMap& a, const PatchMap& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const PatchPoint& p, const PatchPoint& q) {
                      return p.vertex == q.vertex && p.patch == q.patch && p.uv == q.uv && p.axis == q.axis &&
                             p.weight == q.weight;
                    }) &&
         std::equal(a.patch_triangles.begin(), a.patch_triangles.end(), b.patch_triangles.begin(),
                    b.patch_triangles.end(), [](const PatchTriangle& p, const PatchTriangle& q) {
                      return p.triangle == q.triangle && p.patch == q.patch && p.points == q.points;
                    });
}

/// A bumpy sheet: a grid with random heights.
RawModel sheet(int side, double height) {
  RawModel raw;
  for (int i = 0; i < side * side; ++i) {
    const double x = i % side, z = i / side;
    raw.positions.emplace_back(x / side, height * between(-1, 1), z / side);
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const auto at = static_cast<std::uint32_t>(y * side + x), row = static_cast<std::uint32_t>(side);
      raw.face_sizes.insert(raw.face_sizes.end(), {3, 3});
      raw.corners.insert(raw.corners.end(), {at, at + row, at + 1, at + 1, at + row, at + row + 1});
    }
  }
  return raw;
}

RC_GTEST_PROP(Patches, SameMeshSameBits, ()) {
  const Result<Mesh> mesh = prepare(sheet(whole(2, 24), between(0, 0.2)));
  RC_PRE(mesh.ok());
  const PatchMap map = lay_patches(*mesh);
  check_patches(*mesh, map);
  RC_ASSERT(same_bits(map, lay_patches(*mesh)));
}

RC_GTEST_PROP(Patches, HardBordersKeepOnePatchTriangleOfEachTriangle, ()) {
  const Result<Mesh> mesh = prepare(sheet(whole(2, 24), between(0, 0.2)));
  RC_PRE(mesh.ok());
  const PatchMap hard = with_hard_borders(lay_patches(*mesh));
  RC_ASSERT(hard.patch_triangles.size() == mesh->triangles.size());
  for (std::size_t t = 0; t < hard.patch_triangles.size(); ++t) RC_ASSERT(hard.patch_triangles[t].triangle == t);
  check_patches(*mesh, hard);
}

/// Bumps about as large as their triangles cannot be mapped without stretch, but rarely flip.
RC_GTEST_PROP(Patches, FewPatchTrianglesAreFlipped, ()) {
  const Result<Mesh> mesh = prepare(sheet(whole(8, 24), between(0, 0.05)));
  RC_PRE(mesh.ok());
  const PatchMap map = lay_patches(*mesh);
  const auto flipped = std::count_if(
      map.patch_triangles.begin(), map.patch_triangles.end(),
      [&](const PatchTriangle& patch_triangle) { return stretch_of(*mesh, map, patch_triangle).flipped; });
  RC_ASSERT(static_cast<double>(flipped) <= 0.02 * static_cast<double>(map.patch_triangles.size()));
}

RC_GTEST_PROP(Prepare, ScaleChangesNothingInside, ()) {
  const RawModel raw = soup(false);
  RawModel larger = raw;
  for (glm::dvec3& p : larger.positions) p *= 4.0;  // exact in floating point
  const Result<Mesh> a = prepare(raw);
  const Result<Mesh> b = prepare(larger);
  RC_PRE(a.ok() && b.ok());
  RC_ASSERT(a->positions == b->positions && a->normals == b->normals && a->triangles == b->triangles);
  RC_ASSERT(b->size == 4 * a->size);
}

std::array<glm::dvec3, 3> corners_of(const Mesh& mesh, const glm::uvec3& t) {
  return {glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])};
}

RC_GTEST_PROP(Surface, NearestAgreesWithEveryTriangleTried, ()) {
  Result<Mesh> mesh = prepare(soup(false));
  RC_PRE(mesh.ok());
  const Surface surface(std::move(mesh).value());
  const glm::dvec3 from = std::pow(10.0, whole(-3, 5)) * random_position(false);
  double min = std::numeric_limits<double>::infinity();
  for (const glm::uvec3& t : surface.mesh().triangles) {
    min = std::min(min, nearest_on_triangle(corners_of(surface.mesh(), t), from).distance);
  }
  const SurfacePoint point = surface.nearest(from);
  RC_ASSERT(std::abs(glm::length(surface.position(point) - from) - min) <= 1e-9 * (1 + min));
  for (int k = 0; k < 3; ++k) RC_ASSERT(point.barycentric[k] >= 0 && point.barycentric[k] <= 1);
}

/// No point of a triangle, on a fine grid, is nearer than the one found.
RC_GTEST_PROP(Surface, NearestOnTriangleIsNearest, ()) {
  const std::array<glm::dvec3, 3> corners = {random_position(false), random_position(false), random_position(false)};
  const glm::dvec3 from = random_position(false) * 2.0;
  const TrianglePoint found = nearest_on_triangle(corners, from);
  constexpr int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double v = static_cast<double>(i) / steps, w = static_cast<double>(j) / steps;
      const glm::dvec3 p = (1 - v - w) * corners[0] + v * corners[1] + w * corners[2];
      RC_ASSERT(found.distance <= glm::length(p - from) + 1e-12);
    }
  }
}

/// Distance along the unit ray to the triangle, and how far inside the triangle it crosses (negative: outside).
struct Crossing {
  double distance = -1, inside = -1;
};

Crossing cross_triangle(const std::array<glm::dvec3, 3>& c, glm::dvec3 origin, glm::dvec3 direction) {
  const glm::dvec3 e1 = c[1] - c[0], e2 = c[2] - c[0], p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (std::abs(determinant) < 1e-9) return {};
  const glm::dvec3 s = origin - c[0], q = glm::cross(s, e1);
  const double v = glm::dot(s, p) / determinant, w = glm::dot(direction, q) / determinant;
  return {glm::dot(e2, q) / determinant, std::min({v, w, 1 - v - w})};
}

RC_GTEST_PROP(Surface, RaysAgreeWithEveryTriangleTried, ()) {
  Result<Mesh> mesh = prepare(soup(false));
  RC_PRE(mesh.ok());
  const Surface surface(std::move(mesh).value());
  const glm::dvec3 origin = random_position(false) * 2.0,
                   direction = glm::normalize(random_position(false) * 0.3 - origin);
  RC_PRE(std::isfinite(direction.x));
  constexpr double clear = 1e-3;  // rounding may decide whatever is closer to an edge or to the origin
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::uvec3& t : surface.mesh().triangles) {
    const Crossing crossing = cross_triangle(corners_of(surface.mesh(), t), origin, direction);
    if (crossing.distance > clear && crossing.inside > clear) nearest = std::min(nearest, crossing.distance);
  }
  const auto hit = surface.raycast(origin, direction);
  if (std::isfinite(nearest)) RC_ASSERT(hit.has_value());
  if (!hit) return;
  const glm::dvec3 at = surface.position(*hit);
  RC_ASSERT(glm::length(glm::cross(at - origin, direction)) < 1e-4);
  RC_ASSERT(glm::dot(at - origin, direction) < nearest + 1e-4);
}

RC_GTEST_PROP(Surface, VerticesWithinAgreeWithEveryVertexTried, ()) {
  Result<Mesh> mesh = prepare(soup(false));
  RC_PRE(mesh.ok());
  const Surface surface(std::move(mesh).value());
  const auto& positions = surface.mesh().positions;
  const bool at_vertex = *rc::gen::arbitrary<bool>();
  const auto some = [&] { return static_cast<std::size_t>(whole(0, static_cast<int>(positions.size()))); };
  const glm::dvec3 centre = at_vertex ? glm::dvec3(positions[some()]) : random_position(false);
  // Often the exact distance of a vertex, so that "at most" is tested.
  const double radius = *rc::gen::element(0.0, between(0, 2), glm::length(centre - glm::dvec3(positions[some()])));
  std::vector<std::uint32_t> expected, found;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (glm::length(centre - glm::dvec3(positions[v])) <= radius) expected.push_back(v);
  }
  surface.vertices_within(centre, radius, found);
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(Surface, VerticesAlongALineAgreeWithEveryVertexTried, ()) {
  Result<Mesh> mesh = prepare(soup(false));
  RC_PRE(mesh.ok());
  const Surface surface(std::move(mesh).value());
  const auto& positions = surface.mesh().positions;
  const glm::dvec3 from = random_position(false), to = *rc::gen::arbitrary<bool>() ? from : random_position(false),
                   along = to - from;
  const auto distance = [&](glm::dvec3 point) {
    const double share = along == glm::dvec3(0) ? 0 : glm::dot(point - from, along) / glm::dot(along, along);
    return glm::length(from + std::clamp(share, 0.0, 1.0) * along - point);
  };
  const double radius = *rc::gen::element(between(0, 0.1), between(0, 2));
  std::vector<std::uint32_t> expected, found;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (distance(glm::dvec3(positions[v])) <= radius) expected.push_back(v);
  }
  surface.vertices_along(from, to, radius, found);
  RC_ASSERT(found == expected);
}

}  // namespace
}  // namespace pelage
