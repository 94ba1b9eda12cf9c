#include "renderer/overlay/shape_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "renderer/overlay/plain_overlay.h"

namespace pelage {

namespace {

// sRGB
constexpr float behind = 0.24f, darkest = 0.34f, lightest = 0.86f;
constexpr glm::vec3 edge_colour(0.08f, 0.18f, 0.32f);

struct Shape {
  const FurFrame& frame;
  const FurModel& model;
  const FloatImage &normals, &pieces;

  static std::size_t index(const FloatImage& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  }
  bool there(int x, int y) const { return normals.rgba[index(normals, x, y) + 3] > 0; }

  /// Brightest where the skin is front-facing.
  float grey_at(int x, int y) const {
    if (!there(x, y)) return behind;
    const float* normal = &normals.rgba[index(normals, x, y)];
    const FurCamera& camera = frame.camera;
    const float over = 2 * camera.tan_half_fov / static_cast<float>(frame.height);
    const glm::vec2 off = (glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(frame.width, frame.height)) * over;
    const glm::vec3 way = camera.forward + off.x * camera.right - off.y * camera.up;
    const float facing = std::abs(glm::dot(glm::vec3(normal[0], normal[1], normal[2]), glm::normalize(way)));
    return glm::mix(darkest, lightest, std::min(facing, 1.0f));
  }

  /// The vertices of a piece in rising order: pieces of the skin overlap, and several have the same.
  std::array<std::uint32_t, 3> corners_at(int x, int y) const {
    const glm::uvec3 t = model.triangles[static_cast<std::size_t>(pieces.rgba[index(pieces, x, y)])];
    std::array<std::uint32_t, 3> corners{t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  /// Whether the pixel to the right or below shows another triangle.
  bool is_edge(int x, int y) const {
    const auto differs = [&](int beside_x, int beside_y) {
      if (beside_x >= frame.width || beside_y >= frame.height) return false;
      const bool here = there(x, y), beside = there(beside_x, beside_y);
      return here != beside || (here && corners_at(x, y) != corners_at(beside_x, beside_y));
    };
    return differs(x + 1, y) || differs(x, y + 1);
  }
};

}  // namespace

FloatImage shape_picture(const FurFrame& frame, const FurModel& model, const FloatImage& normals,
                         const FloatImage& pieces, int threads) {
  assert(normals.width == frame.width && pieces.width == frame.width);
  const Shape shape{frame, model, normals, pieces};
  return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) {
    const glm::vec3 grey(shape.grey_at(x, y));
    const bool edge = frame.overlay == Overlay::wire && shape.is_edge(x, y);
    return glm::vec4(edge ? glm::mix(grey, edge_colour, 0.7f) : grey, 1);
  });
}

}  // namespace pelage
