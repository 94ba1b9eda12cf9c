// A position of a surface in the rest pose, in which the coat was made; patterns and tufts depend on it.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace pelage {

/// A position in the rest pose. `rotation` maps directions from the rest pose to the current pose.
struct RestPosePoint {
  glm::vec3 position{0}, normal{0, 1, 0};  // internal coordinates; the normal is unit
  glm::mat3 rotation{1};                   // a rotation
};

/// Returns the rotation from a triangle of the rest pose to the current one: it maps the first side's direction and the
/// normal. The identity if either triangle has no area.
glm::mat3 rotation_of_triangle(const std::array<glm::vec3, 3>& rest, const std::array<glm::vec3, 3>& now);

}  // namespace pelage
