// A level patch of fur for tests: n x n quads over a square in the plane z = 0. Normals point up, tangents and the
// tile's u are along x, and positions are also the positions on the tile.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/grow.h"

namespace pelage {

struct FurPatch {
  FurPatch() = default;
  explicit FurPatch(double side, int quads = 1, float fur = 0.03f) {
    const int row = quads + 1;
    for (int y = 0; y < row; ++y) {
      for (int x = 0; x < row; ++x) positions.emplace_back(glm::dvec2(x, y) * (side / quads), 0);
    }
    normals.assign(positions.size(), {0, 0, 1}), tangents.assign(positions.size(), {1, 0, 0});
    direction.assign(positions.size(), glm::vec2(0)), length.assign(positions.size(), fur);
    for (int y = 0; y < quads; ++y) {
      for (int x = 0; x < quads; ++x) {
        const auto a = static_cast<unsigned>(y * row + x), b = a + 1, c = a + static_cast<unsigned>(row), d = c + 1;
        add({a, b, d}), add({a, d, c});
      }
    }
  }

  void add(glm::uvec3 triangle) {
    std::array<FurCorner, 3> of_triangle;
    for (int i = 0; i < 3; ++i) {
      FurCorner& corner = of_triangle[static_cast<std::size_t>(i)];
      corner.tile_uv = glm::vec2(positions[triangle[i]]);
      corner.tile_axis = {1, 0, 0};
      corner.image_uv = corner.tile_uv;
    }
    triangles.push_back(triangle), corners.push_back(of_triangle);
  }

  FurModel model() const {
    FurModel view;
    view.id = id, view.positions = positions, view.normals = normals, view.tangents = tangents;
    view.triangles = triangles, view.corners = corners, view.images = images;
    view.rest_positions = rest_positions, view.rest_normals = rest_normals;
    return view;
  }
  FurFields fields() const { return {direction, length, {}, skin, paint}; }
  Grower grower(const GrowRecipe& recipe) const { return {model(), fields(), recipe}; }
  StrandChunk all() const {
    StrandChunk chunk;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) chunk.push_back(i);
    return chunk;
  }
  StrandSet grow(const GrowRecipe& recipe) const { return grower(recipe).grow(all()); }

  std::uint64_t id = 1;
  std::vector<glm::vec3> positions, normals, tangents;
  std::vector<glm::vec3> rest_positions, rest_normals;  // set for a patch that has moved
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<FurCorner, 3>> corners;
  std::vector<ImageView> images;
  std::vector<glm::vec2> direction;
  std::vector<float> length;
  std::vector<FurSkinRegion> skin;
  FurPaint paint;
};

/// A coat whose strands are alike, straight and of one colour.
inline Coat plain_coat(int count = 1000) {
  Coat coat;
  coat.count = count;
  coat.bend = coat.clump = coat.length_spread = coat.colour_spread = coat.root_share = 0;
  coat.ramp = {{0, {0.4f, 0.2f, 0.1f}}};
  return coat;
}

inline const StrandPoint& knot(const StrandSet& set, std::size_t strand, int k) {
  return set.points[strand * static_cast<std::size_t>(set.segments + 1) + static_cast<std::size_t>(k)];
}
inline const StrandPoint& tip(const StrandSet& set, std::size_t strand) { return knot(set, strand, set.segments); }

/// All data of each strand as words, sorted: equal for the same strands in any order.
std::vector<std::vector<std::uint32_t>> sorted_strands(const StrandSet& set);
/// Number of strands of `part` that are in `whole`, bit for bit.
std::size_t count_shared(const StrandSet& part, const StrandSet& whole);

}  // namespace pelage
