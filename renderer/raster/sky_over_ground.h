// Computes how much of the sky a model and its fur hide from the ground around it.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/raster/light_cells.h"

namespace pelage {

/// A map of the ground: entry i of row k is at the position low + (i, k) cell, in x and z. Beyond the map nothing is
/// hidden.
struct SkyOverGround {
  glm::vec2 low{0};
  float cell = 1;             // distance between entries, sizes
  glm::ivec2 size{0};         // entries in x and z, at least 2; 0 if nothing is hidden
  std::vector<float> hidden;  // share of a uniform sky's light that is hidden, cosine-weighted, [0, 1]
};

/// Returns the layout of the map around a grid, without its entries.
SkyOverGround sky_map(const GridLayout& layout);

/// Returns the map of a ground at `height`, sizes. Each column of the grid is taken as solid from the lowest to the
/// highest point of what stands in it.
SkyOverGround sky_over_ground(const GridLayout& layout, std::span<const CellDensity> density, const FurModel& model,
                              float height, int threads);

}  // namespace pelage
