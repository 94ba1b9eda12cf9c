#include "renderer/quality/windows.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {

int window_side(int width, int height) { return std::clamp(std::min(width, height) / 8, 40, 64); }

FurFrame fur_alone(FurFrame frame) {
  frame.background = Background::transparent;
  frame.ground.reset(), frame.overlay = Overlay::none, frame.difference.clear();
  return frame;
}

FurFrame window_of(const FurFrame& frame, glm::vec2 place, int side) {
  assert(side > 0);
  const FurCamera& whole = frame.camera;
  const glm::vec2 size(frame.width, frame.height);
  const glm::vec2 off = (place - 0.5f * size) * (2 * whole.tan_half_fov / size.y);  // over the distance along the view
  FurFrame window = fur_alone(frame);
  FurCamera& camera = window.camera;
  camera.forward = glm::normalize(whole.forward + off.x * whole.right - off.y * whole.up);
  camera.right = glm::normalize(glm::cross(camera.forward, whole.up));
  camera.up = glm::cross(camera.right, camera.forward);
  // A pixel off the axis spans a smaller angle: by the cosine across, by its square along.
  const float cosine = 1 / std::sqrt(1 + glm::dot(off, off));
  camera.tan_half_fov = whole.tan_half_fov * static_cast<float>(side) / size.y * cosine * std::sqrt(cosine);
  window.width = window.height = side;
  return window;
}

}  // namespace pelage
