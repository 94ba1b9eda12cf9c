#include "renderer/pattern/surface_volume.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {

namespace {

constexpr float finest_cell = 0.005f;
constexpr int max_cells = 256;

/// Fills the grid from points on the surface: each evaluates the eight cells that a fetch there would read.
class Filler {
 public:
  Filler(const VolumeValue& value, SurfaceVolume& volume) : value_(value), volume_(volume) {
    const auto cells = static_cast<std::size_t>(volume.size.x) * static_cast<std::size_t>(volume.size.y) *
                       static_cast<std::size_t>(volume.size.z);
    volume_.rgba.assign(4 * cells, 0);
    filled_.assign(cells, false);
  }

  void fill_about(glm::vec3 place, glm::vec3 normal) {
    const glm::ivec3 first(glm::floor((place - volume_.origin) / volume_.cell - 0.5f));
    for (int k = 0; k < 8; ++k) fill(first + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2), normal);
  }

 private:
  void fill(glm::ivec3 at, glm::vec3 normal) {
    at = glm::clamp(at, glm::ivec3(0), volume_.size - 1);
    const auto cell =
        (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(volume_.size.y) + static_cast<std::size_t>(at.y)) *
            static_cast<std::size_t>(volume_.size.x) +
        static_cast<std::size_t>(at.x);
    if (filled_[cell]) return;
    filled_[cell] = true;
    const glm::vec3 middle = volume_.origin + (glm::vec3(at) + 0.5f) * volume_.cell;
    const glm::vec4 value = glm::clamp(value_(middle, normal), 0.0f, 1.0f);
    for (int k = 0; k < 4; ++k)
      volume_.rgba[4 * cell + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * value[k]));
  }

  const VolumeValue& value_;
  SurfaceVolume& volume_;
  std::vector<bool> filled_;
};

/// Calls `visit` with barycentrics at most half a cell apart over a triangle.
template <class Visit>
void for_each_point(glm::vec3 a, glm::vec3 b, glm::vec3 c, float spacing, Visit visit) {
  const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const int steps = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps - i; ++j) {
      const float u = static_cast<float>(i) / static_cast<float>(steps),
                  v = static_cast<float>(j) / static_cast<float>(steps);
      visit(glm::vec3(1 - u - v, u, v));
    }
  }
}

}  // namespace

SurfaceVolume make_surface_volume(const VolumeSurface& surface, const VolumeValue& value) {
  assert(!surface.positions.empty());
  glm::vec3 low = surface.positions.front(), high = low;
  for (const glm::vec3& p : surface.positions) low = glm::min(low, p), high = glm::max(high, p);
  SurfaceVolume volume;
  const glm::vec3 extent = high - low;
  volume.cell = std::max(finest_cell, std::max({extent.x, extent.y, extent.z}) / (max_cells - 2));
  volume.origin = low - volume.cell;
  volume.size = glm::min(glm::ivec3(glm::ceil(extent / volume.cell)) + 2, glm::ivec3(max_cells));
  Filler filler(value, volume);
  for (const glm::uvec3& t : surface.triangles) {
    const glm::vec3 a = surface.positions[t.x], b = surface.positions[t.y], c = surface.positions[t.z];
    for_each_point(a, b, c, 0.5f * volume.cell, [&](glm::vec3 w) {
      const glm::vec3 sum = w.x * surface.normals[t.x] + w.y * surface.normals[t.y] + w.z * surface.normals[t.z];
      const float length = glm::length(sum);
      filler.fill_about(w.x * a + w.y * b + w.z * c, length > 0 ? sum / length : surface.normals[t.x]);
    });
  }
  return volume;
}

}  // namespace pelage
