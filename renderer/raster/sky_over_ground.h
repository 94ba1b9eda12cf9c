// How much of the sky a model and its fur hide from the ground around it.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/raster/light_cells.h"

namespace pelage {

/// A map over the ground: number i of row k is of the place low + (i, k) cell, in x and z. Nothing is hidden beyond.
struct SkyOverGround {
  glm::vec2 low{0};
  float cell = 1;             // sizes
  glm::ivec2 size{0};         // 0 where nothing is hidden; else at least 2
  std::vector<float> hidden;  // [0, 1], of light that comes from all sides as from a matt sky
};

/// The map around a grid, of nothing.
SkyOverGround sky_map(const GridPlace& place);

/// Of the ground at that height, sizes. What stands in a column of the grid is taken for solid from the lowest of it to
/// the highest.
SkyOverGround sky_over_ground(const GridPlace& place, std::span<const CellDensity> density, const FurModel& model,
                              float height, int threads);

}  // namespace pelage
