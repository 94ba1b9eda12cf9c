// A place of a surface as patterns and tufts know it: where it lay when the coat was made.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace pelage {

/// `turn` takes directions from there to where the surface is now.
struct RestPosePoint {
  glm::vec3 place{0}, normal{0, 1, 0};  // internal coordinates, unit
  glm::mat3 turn{1};                    // a rotation
};

/// The rotation from a triangle of the rest pose to where it is now: of its first side and of its normal. None for a
/// triangle that has no area there or here.
glm::mat3 turn_of_triangle(const std::array<glm::vec3, 3>& rest, const std::array<glm::vec3, 3>& now);

}  // namespace pelage
