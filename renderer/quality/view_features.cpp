#include "renderer/quality/view_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

constexpr std::size_t max_triangles = 16384;   // maximum number of triangles to examine
constexpr double furthest_back_facing = -0.6;  // smallest cosine to the camera at which fur is visible
constexpr double nearest = 1e-3;               // minimum distance along the view direction, sizes
constexpr double cells_across = 32;            // cells across the picture; larger triangles are split into parts
constexpr double max_parts = 16;               // parts along a triangle's side
constexpr double max_depth_complexity = 16;    // limit on the mean depth complexity of skin
constexpr double max_fur = 1e6;                // pixels

class Looker {
 public:
  Looker(const FurFrame& frame, const FurredSkin& skin) : frame_(frame), skin_(skin) {
    focal_ = frame.height / (2.0 * std::max(1e-6, static_cast<double>(frame.camera.tan_half_fov)));
  }

  void look(const glm::uvec3& triangle);
  /// Returns the features, scaled to `times` as many triangles as were examined.
  ViewFeatures features(double times) const;

 private:
  glm::dvec3 seen(std::uint32_t vertex, double length) const;
  void spread(const std::array<glm::dvec3, 3>& corners, double area, double length, double on_skin);

  const FurFrame& frame_;
  const FurredSkin& skin_;
  double focal_ = 1;  // pixels
  double area_ = 0, fur_ = 0, sizes_ = 0;
  double seen_skin_ = 0;  // sizes^2
};

/// Returns the column and the row in pixels, and the depth, of a vertex at the middle of the fur's height.
glm::dvec3 Looker::seen(std::uint32_t vertex, double length) const {
  const glm::dvec3 normal(skin_.normals[vertex]);
  const glm::dvec3 offset =
      glm::dvec3(skin_.positions[vertex]) + 0.5 * length * normal - glm::dvec3(frame_.camera.position);
  const double depth = std::max(nearest, glm::dot(offset, glm::dvec3(frame_.camera.forward)));
  return {frame_.width / 2.0 + focal_ * glm::dot(offset, glm::dvec3(frame_.camera.right)) / depth,
          frame_.height / 2.0 - focal_ * glm::dot(offset, glm::dvec3(frame_.camera.up)) / depth, depth};
}

void Looker::look(const glm::uvec3& t) {
  const glm::dvec3 a(skin_.positions[t.x]), b(skin_.positions[t.y]), c(skin_.positions[t.z]);
  const glm::dvec3 normal = glm::cross(b - a, c - a),
                   to_camera = glm::dvec3(frame_.camera.position) - (a + b + c) / 3.0;
  const double size = glm::length(normal) * glm::length(to_camera);
  if (!(size > 0) || glm::dot(normal, to_camera) <= furthest_back_facing * size) return;
  const double length = (double{skin_.length[t.x]} + skin_.length[t.y] + skin_.length[t.z]) / 3;
  const std::array<glm::dvec3, 3> corners{seen(t.x, length), seen(t.y, length), seen(t.z, length)};
  if (std::max({corners[0].z, corners[1].z, corners[2].z}) <= nearest) return;
  const glm::dvec2 first(corners[1] - corners[0]), second(corners[2] - corners[0]);
  spread(corners, std::abs(first.x * second.y - first.y * second.x) / 2, length, glm::length(normal) / 2);
}

/// Adds the parts of a triangle whose middles lie in the picture; the parts are n x n equal triangles.
void Looker::spread(const std::array<glm::dvec3, 3>& corners, double area, double length, double on_skin) {
  const double cell_size = std::sqrt(double(frame_.width) * frame_.height) / cells_across;
  const int n = static_cast<int>(std::clamp(std::ceil(std::sqrt(area) / cell_size), 1.0, max_parts));
  const double part = area / (n * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {
      const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
      const double u = (i + third) / n, v = (j / 2 + third) / n;
      const glm::dvec3 at = corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v;
      if (!(at.x >= 0 && at.x < frame_.width && at.y >= 0 && at.y < frame_.height)) continue;
      area_ += part, fur_ += part * length * focal_ / at.z, sizes_ += part * focal_ / at.z,
          seen_skin_ += on_skin / (n * n);
    }
  }
}

ViewFeatures Looker::features(double times) const {
  ViewFeatures view;
  view.pixels = double(frame_.width) * frame_.height;
  view.area = std::min(area_ * times * skin_.patch_triangles, max_depth_complexity * view.pixels);
  view.fur_pixels = area_ > 0 ? std::min(fur_ / area_, max_fur) : 0;
  view.lights = static_cast<double>(frame_.lights.size());
  const Coat& coat = frame_.coat();
  view.width_pixels = area_ > 0 ? std::min(coat.width_root * sizes_ / area_, max_fur) : 0;
  view.winding = winding(coat);
  for (const NamedCoat& one : frame_.coats) view.strands += expected_strands(seen_skin_ * times, one.coat);
  return view;
}

}  // namespace

ViewFeatures view_features(const FurFrame& frame, const FurredSkin& skin) {
  const std::size_t stride = skin.triangles.size() / max_triangles + 1;
  Looker looker(frame, skin);
  std::size_t looked = 0;
  for (std::size_t i = 0; i < skin.triangles.size(); i += stride, ++looked) looker.look(skin.triangles[i]);
  return looker.features(looked ? static_cast<double>(skin.triangles.size()) / static_cast<double>(looked) : 1);
}

}  // namespace pelage
