#include "renderer/marched/shape_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "renderer/marched/visible_triangles.h"
#include "renderer/overlay/plain_overlay.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

// sRGB
constexpr float behind = 0.24f, darkest = 0.34f, lightest = 0.86f;
constexpr glm::vec3 edge_colour(0.08f, 0.18f, 0.32f);

/// The model's own vertices of a triangle, in rising order: pieces of the skin overlap, and have theirs twice.
std::array<std::uint32_t, 3> corners_of(const MarchMesh& mesh, std::uint32_t triangle) {
  const glm::uvec3 t = mesh.triangles[triangle];
  std::array<std::uint32_t, 3> corners{mesh.welded[t.x], mesh.welded[t.y], mesh.welded[t.z]};
  std::sort(corners.begin(), corners.end());
  return corners;
}

struct Shape {
  const FurFrame& frame;
  const MarchMesh& mesh;
  std::vector<VisibleTriangle> seen;

  const VisibleTriangle& at(int x, int y) const {
    return seen[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)];
  }

  /// Brightest where the skin is front-facing.
  float grey_at(int x, int y) const {
    const VisibleTriangle& here = at(x, y);
    if (!here.there()) return behind;
    const glm::uvec3 t = mesh.triangles[here.triangle];
    const auto between = [&](const auto& values) { return at_visible(here, values[t.x], values[t.y], values[t.z]); };
    const glm::vec3 to_camera = frame.camera.position - between(mesh.positions);
    const glm::vec3 normal = between(mesh.normals);
    const float lengths = glm::length(normal) * glm::length(to_camera);
    const float facing = lengths > 0 ? std::abs(glm::dot(normal, to_camera)) / lengths : 0.0f;
    return glm::mix(darkest, lightest, facing);
  }

  /// Whether the pixel to the right or below shows another triangle.
  bool is_edge(int x, int y) const {
    const auto differs = [&](int beside_x, int beside_y) {
      if (beside_x >= frame.width || beside_y >= frame.height) return false;
      const VisibleTriangle &here = at(x, y), &beside = at(beside_x, beside_y);
      if (here.triangle == beside.triangle) return false;
      if (!here.there() || !beside.there()) return true;
      return corners_of(mesh, here.triangle) != corners_of(mesh, beside.triangle);
    };
    return differs(x + 1, y) || differs(x, y + 1);
  }
};

}  // namespace

bool is_shape(Overlay overlay) { return overlay == Overlay::bald || overlay == Overlay::wire; }

FloatImage shape_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads) {
  const glm::vec3 forward = frame.camera.forward;
  const PlainView view{
      world_to_clip(frame), {forward, -glm::dot(forward, frame.camera.position)}, frame.width, frame.height};
  const Shape shape{frame, mesh, visible_triangles(mesh.positions, mesh.triangles, view, threads)};
  return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) {
    const glm::vec3 grey(shape.grey_at(x, y));
    const bool edge = frame.overlay == Overlay::wire && shape.is_edge(x, y);
    return glm::vec4(edge ? glm::mix(grey, edge_colour, 0.7f) : grey, 1);
  });
}

}  // namespace pelage
