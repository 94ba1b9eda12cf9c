#include "renderer/pattern/rest_pose.h"

#include <optional>

namespace pelage {

namespace {

/// Returns the local frame of a triangle, none if it has no area. Columns: along the first side, across it in the
/// triangle's plane, the normal.
std::optional<glm::mat3> frame_of(const std::array<glm::vec3, 3>& triangle) {
  const glm::dvec3 side(triangle[1] - triangle[0]), other(triangle[2] - triangle[0]);
  const glm::dvec3 across = glm::cross(side, other);
  const double area = glm::length(across), length = glm::length(side);
  if (!(area > 1e-12 * length * glm::length(other)) || !(length > 0)) return {};
  const glm::dvec3 x = side / length, z = across / area;
  return glm::mat3(glm::dmat3(x, glm::cross(z, x), z));
}

}  // namespace

glm::mat3 rotation_of_triangle(const std::array<glm::vec3, 3>& rest, const std::array<glm::vec3, 3>& now) {
  const std::optional<glm::mat3> from = frame_of(rest), to = frame_of(now);
  return from && to ? *to * glm::transpose(*from) : glm::mat3(1);
}

}  // namespace pelage
