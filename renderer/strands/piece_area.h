// Where a piece lies on the plane that the tile repeats over.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/tile_cells.h"

namespace pelage {

/// Sizes.
inline std::array<glm::dvec2, 3> tile_triangle(const std::array<FurCorner, 3>& corners) {
  return {corners[0].tile_uv, corners[1].tile_uv, corners[2].tile_uv};
}

/// Strands of whole fur that a piece grows in the mean; 0 where TileCells finds none.
inline double expected_strands(const std::array<FurCorner, 3>& corners, const Coat& coat) {
  const auto [a, b, c] = tile_triangle(corners);
  const glm::dvec2 furthest = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
  if (!(furthest.x <= TileCells::furthest && furthest.y <= TileCells::furthest)) return 0;
  const double area = 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const double weight = (corners[0].weight + corners[1].weight + corners[2].weight) / 3.0;
  return area * weight * coat.count / (coat.tile * coat.tile);
}

}  // namespace pelage
