// Builds all mip levels of a coat's slices from the full-size ones, ready for the GPU.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

/// A texel during baking. Slope and colour are premultiplied by depth, so that sums and means of texels are correct.
struct SliceTexel {
  float depth = 0;
  glm::vec2 slope{0};
  glm::vec3 colour{0};
  float number = 0;
  float light = 0;

  void add(const SliceTexel& other) {
    if (other.depth > depth * 0.5f) number = other.number;  // numbers cannot be averaged: the thickest strand's wins
    depth += other.depth;
    slope += other.slope;
    colour += other.colour;
    light += other.light;
  }
};

/// Light from above on the cells of each slice, and the number of strands above it (Slices::depth_above).
struct StackLight {
  std::array<std::vector<float>, slice_count> cells;  // crossing_cells^2, x fastest
  std::array<float, slice_count> depth_above{};
};
StackLight light_from_above(const Coat& coat, const std::vector<Strand>& strands);

/// Writes the light of one slice's cells into the texels of the full-size slice.
void set_light(const std::vector<float>& cells, std::vector<SliceTexel>& slice);

/// Builds all levels. `stack` has slice_count full-size slices of these strands.
std::vector<SliceLevel> build_levels(const Coat& coat, const std::vector<Strand>& strands,
                                     std::vector<std::vector<SliceTexel>> stack);

}  // namespace pelage
