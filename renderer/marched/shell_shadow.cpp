#include "renderer/marched/shell_shadow.h"

#include <cmath>

#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

constexpr float far_away = 200;  // sizes: a light that is everywhere differs from one there by .3 degrees over the body

}  // namespace

FurFrame frame_of_light(const FurFrame& frame, const FurLight& light, float radius) {
  const bool directional = light.kind == LightKind::directional;
  const glm::vec3 position = directional ? -light.direction * far_away : light.position;
  const float distance = glm::length(position);
  FurCamera camera;
  camera.position = position, camera.forward = -position / distance;
  const glm::vec3 hint = std::abs(camera.forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  camera.right = glm::normalize(glm::cross(camera.forward, hint));
  camera.up = glm::cross(camera.right, camera.forward);
  camera.tan_half_fov = radius / std::sqrt(distance * distance - radius * radius);
  FurFrame seen = frame;
  seen.camera = camera;
  seen.width = seen.height = frame.knobs.shadow_resolution;
  seen.knobs.scale = 1, seen.knobs.shadow_maps = false;
  seen.ground.reset();
  seen.eyes.clear();  // curves have maps of their own, and are not in this one
  return seen;
}

ShellSet shadow_shell_set() {
  ShellSet shells;
  for (int i = 0; i <= shadow_shells; ++i) {
    shells.heights.push_back(static_cast<float>(i) / shadow_shells);
    shells.facing.push_back(2);
  }
  return shells;
}

std::size_t shell_map_numbers(int side) {
  return std::size_t{shadow_shells + 1} * static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
}

}  // namespace pelage
