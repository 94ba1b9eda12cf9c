#include "renderer/upload/shadow_block.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr float far_away = 16;  // sizes: where the eye of a directional light stands

struct Axes {
  glm::vec3 right, up, forward;
};

Axes axes_along(glm::vec3 forward) {
  const glm::vec3 hint = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 right = glm::normalize(glm::cross(forward, hint));
  return {right, glm::cross(right, forward), forward};
}

glm::mat4 view_matrix(const Axes& axes, glm::vec3 viewpoint) {
  const glm::mat3 turn = glm::transpose(glm::mat3(axes.right, axes.up, -axes.forward));
  glm::mat4 matrix(turn);
  matrix[3] = glm::vec4(-(turn * viewpoint), 1);
  return matrix;
}

LightView directional_view(glm::vec3 direction, float radius, int resolution) {
  const Axes axes = axes_along(direction);
  const glm::vec3 viewpoint = -direction * far_away;
  glm::mat4 projection(0);  // depth 1 in front of the ball, 0 behind it
  projection[0][0] = projection[1][1] = 1 / radius;
  projection[2][2] = 1 / (2 * radius);
  projection[3][2] = (far_away + radius) / (2 * radius);
  projection[3][3] = 1;
  return {projection * view_matrix(axes, viewpoint),
          viewpoint,
          {direction, radius},
          2 * radius / (static_cast<float>(resolution) * far_away)};
}

LightView point_view(glm::vec3 position, float radius, int resolution) {
  const float distance = glm::length(position);
  const glm::vec3 forward = -position / distance;
  const float tangent = radius / std::sqrt(distance * distance - radius * radius);
  const float near_plane = 0.5f * (distance - radius);
  glm::mat4 projection(0);
  projection[0][0] = projection[1][1] = 1 / tangent;
  projection[2][3] = -1;
  projection[3][2] = near_plane;
  return {projection * view_matrix(axes_along(forward), position),
          position,
          {forward, -glm::dot(forward, position)},
          2 * tangent / static_cast<float>(resolution)};
}

}  // namespace

std::optional<LightView> view_of_light(const FurLight& light, float radius, int resolution) {
  if (light.kind == LightKind::directional) return directional_view(light.direction, radius, resolution);
  if (!(glm::length(light.position) > 1.1f * radius)) return {};
  return point_view(light.position, radius, resolution);
}

}  // namespace pelage
