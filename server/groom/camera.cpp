#include <algorithm>
#include <cassert>
#include <cmath>

#include "server/groom/evaluate.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

constexpr double frame_margin = 0.08;  // margin around the model in an automatic view, share of the picture
constexpr double min_gap = 0.05;       // minimum depth of the box in front of an automatic camera, sizes

/// Returns the direction from the model to the camera.
glm::dvec3 automatic_direction(AutoView view) {
  switch (view) {
    case AutoView::none: break;
    case AutoView::front: return {0, 0, 1};
    case AutoView::back: return {0, 0, -1};
    case AutoView::left: return {1, 0, 0};
    case AutoView::right: return {-1, 0, 0};
    case AutoView::top: return {0, 1, 0};
    case AutoView::three_quarter: return glm::normalize(glm::dvec3(0.75, 0.45, 1));
  }
  assert(false);
  return {0, 0, 1};
}

/// Computes the camera's right and up from its forward direction. `up` may be any vector; it is replaced if it is
/// parallel to the view direction.
void orient(PlacedCamera& camera, glm::dvec3 up) {
  constexpr double along_view = 1e-9;
  glm::dvec3 right = glm::cross(camera.forward, safe_unit(up));
  if (glm::length(right) < along_view) {
    right = glm::cross(camera.forward, std::abs(camera.forward.y) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0));
  }
  camera.right = glm::normalize(right);
  camera.up = glm::cross(camera.right, camera.forward);
}

/// Moves the camera back until all corners of the box are in the picture with a margin.
void frame_box(PlacedCamera& camera, double aspect, glm::dvec3 low, glm::dvec3 high) {
  const glm::dvec3 target = 0.5 * (low + high);
  const double tan_v = camera.tan_half_fov * (1 - frame_margin), tan_h = tan_v * aspect;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 c =
        glm::dvec3(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z) - target;
    const double nearer = -glm::dot(c, camera.forward);
    const double needed =
        std::max(std::abs(glm::dot(c, camera.right)) / tan_h, std::abs(glm::dot(c, camera.up)) / tan_v);
    distance = std::max(distance, nearer + std::max(needed, min_gap));
  }
  camera.position = target - distance * camera.forward;
}

}  // namespace

PlacedCamera place_camera(const Camera& camera, double aspect, const Mesh& mesh) {
  PlacedCamera placed{};
  placed.tan_half_fov = std::tan(glm::radians(camera.fov_degrees) / 2);
  if (camera.automatic == AutoView::none) {
    placed.position = mesh.to_internal(camera.position);
    placed.forward = safe_unit(mesh.to_internal(camera.target) - placed.position);
    if (placed.forward == glm::dvec3(0)) placed.forward = {0, 0, -1};
    orient(placed, camera.up);
    return placed;
  }
  placed.forward = -automatic_direction(camera.automatic);
  orient(placed, {0, 1, 0});
  frame_box(placed, aspect, mesh.to_internal(mesh.report.bounds.min), mesh.to_internal(mesh.report.bounds.max));
  return placed;
}

glm::dvec3 pixel_ray(const PlacedCamera& camera, glm::dvec2 pixel, int width, int height) {
  const double x = (2 * pixel.x / width - 1) * camera.tan_half_fov * width / height;
  const double y = (1 - 2 * pixel.y / height) * camera.tan_half_fov;
  return camera.forward + x * camera.right + y * camera.up;
}

}  // namespace pelage
