// How much of the sky a model hides from the ground around it: contact() of renderer/passes/ground/ground.frag, for all
// places at once.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

struct GroundContact {
  static constexpr int side = 192;
  static constexpr float extent = 1;  // the square reaches so far to each side of the middle, sizes
  std::vector<float> hidden;          // [0, 1], rows by z, both rising; nothing is hidden beyond
};

/// Of the ground at that height, sizes.
GroundContact make_ground_contact(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                                  float height, int threads);

}  // namespace pelage
