#include "renderer/marched/box_cull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage {

namespace {

/// Pixels that something may touch.
struct Bounds {
  float left, right, top, bottom;
};

Bounds union_of(const Bounds& a, const Bounds& b) {
  return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.top, b.top), std::max(a.bottom, b.bottom)};
}

/// The range of a quotient whose parts lie within so much of their middle; the lower part is above 0.
glm::vec2 quotient_range(float upper, float upper_apart, float lower, float lower_apart) {
  const float least = upper - upper_apart, most = upper + upper_apart;
  return {least / (least < 0 ? lower - lower_apart : lower + lower_apart),
          most / (most < 0 ? lower + lower_apart : lower - lower_apart)};
}

/// Positions of strands on the picture: by rows of the matrix and their sizes.
class Projection {
 public:
  explicit Projection(const MarchScene& scene)
      : scene_(scene), rows_(glm::transpose(scene.optics.frame.world_to_clip)) {
    for (int i = 0; i < 4; ++i) sizes_[i] = glm::length(glm::vec3(rows_[i]));
  }

  /// Of all that a vertex's strand may reach: no further from its root than it is long.
  Bounds of(std::size_t vertex) const {
    const float grown = scene_.mesh.variation.empty() ? 1 : scene_.mesh.variation[vertex].x;
    const float radius = 1.01f * scene_.mesh.groom[vertex].z * std::max(grown, 1.0f) + 1e-5f;
    const glm::vec4 position(scene_.mesh.positions[vertex], 1);
    const float w = glm::dot(rows_[3], position), w_apart = radius * sizes_[3];
    constexpr float any = std::numeric_limits<float>::infinity();
    if (w - w_apart <= near_distance) return {-any, any, -any, any};
    const glm::vec2 x = quotient_range(glm::dot(rows_[0], position), radius * sizes_[0], w, w_apart),
                    y = quotient_range(glm::dot(rows_[1], position), radius * sizes_[1], w, w_apart);
    const auto width = static_cast<float>(scene_.width), height = static_cast<float>(scene_.height);
    return {(0.5f + 0.5f * x.x) * width - 1, (0.5f + 0.5f * x.y) * width + 1, (0.5f - 0.5f * y.y) * height - 1,
            (0.5f - 0.5f * y.x) * height + 1};
  }

 private:
  const MarchScene& scene_;
  glm::mat4 rows_;
  glm::vec4 sizes_{0};
};

/// The tiles of the scene's box.
Bounds tiles_of(const PixelBox& box) {
  const auto down = [](int pixel) { return static_cast<float>(pixel / Tile::side * Tile::side); };
  return {down(box.left), down(box.right + Tile::side - 1), down(box.top), down(box.bottom + Tile::side - 1)};
}

bool touch(const Bounds& a, const Bounds& b) {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

}  // namespace

std::vector<std::uint32_t> pieces_in_box(const MarchScene& scene) {
  const Projection projection(scene);
  std::vector<Bounds> vertices;
  vertices.reserve(scene.mesh.positions.size());
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) vertices.push_back(projection.of(v));
  const Bounds tiles = tiles_of(scene.box);
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const glm::uvec3& t = scene.mesh.triangles[i];
    if (touch(union_of(union_of(vertices[t.x], vertices[t.y]), vertices[t.z]), tiles)) pieces.push_back(i);
  }
  return pieces;
}

}  // namespace pelage
