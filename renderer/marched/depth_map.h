// What a light sees of a mesh: linear depth, without a GL.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/upload/blocks.h"

namespace pelage {

/// Rows from the top of the light's view; `nowhere` where it sees nothing.
struct DepthMap {
  static constexpr float nowhere = 1e4f;  // sizes
  int side = 0;
  std::vector<float> depths;  // side * side, sizes (LightView::axis)

  float at(int x, int y) const {
    return depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
  }
};

/// The nearest of all triangles, whatever side they show.
DepthMap draw_depth_map(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                        const LightView& light, int side, int threads);

}  // namespace pelage
