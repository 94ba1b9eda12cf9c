// From a stack of full-size slices to all levels, ready for the GPU.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

/// A texel while baking. Slope and colour are weighted by depth, so that sums and means are right.
struct SliceTexel {
  float depth = 0;
  glm::vec2 slope{0};
  glm::vec3 colour{0};
  float number = 0;
  float light = 0;

  void add(const SliceTexel& other) {
    if (other.depth > depth * 0.5f) number = other.number;  // the number cannot be mixed: the thickest strand keeps it
    depth += other.depth;
    slope += other.slope;
    colour += other.colour;
    light += other.light;
  }
};

/// `stack` has slice_count slices of slice_texels^2 texels of these strands, `light` unset.
Slices build_levels(const Coat& coat, const std::vector<Strand>& strands, std::vector<std::vector<SliceTexel>> stack);

}  // namespace pelage
