// Where the sample tile lies on the surface. Laid once when the model is prepared; lapped patches come next behind
// this.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// Charts: connected groups of triangles that face about the same way, flattened along the chart's mean normal.
struct TileMap {
  std::vector<std::array<glm::vec2, 3>> corner_uv;  // for each triangle, in sizes (true scale along the mean normal)
  std::vector<std::uint32_t> chart;                 // of each triangle
  std::vector<glm::vec3> axis;                      // of each chart: the tile's u axis in space, unit
};

/// Greedy growth from the lowest unused triangle, across edges, while a triangle's normal stays within `limit_degrees`
/// of the chart's first normal. u runs along the mean tangent of the chart. Deterministic.
TileMap lay_charts(const Mesh& mesh, double limit_degrees = 40);

}  // namespace pelage
