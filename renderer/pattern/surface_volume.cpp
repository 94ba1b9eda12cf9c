#include "renderer/pattern/surface_volume.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {

namespace {

constexpr float finest_cell = 0.005f;
constexpr int max_cells = 256;

/// Fills the grid from points on the surface: for each it evaluates the eight cells that a fetch there would read.
class Filler {
 public:
  Filler(const VolumeValue& value, SurfaceVolume& volume) : value_(value), volume_(volume) {
    const auto cells = static_cast<std::size_t>(volume.size.x) * static_cast<std::size_t>(volume.size.y) *
                       static_cast<std::size_t>(volume.size.z);
    volume_.rgba.assign(4 * cells, 0);
    filled_.assign(cells, false);
  }

  /// Fills the eight cells around a position. `rest_pose_point(middle)` returns a cell's middle in the rest pose.
  template <class RestPose>
  void fill_about(glm::vec3 position, const RestPose& rest_pose_point) {
    const glm::ivec3 first(glm::floor((position - volume_.origin) / volume_.cell - 0.5f));
    for (int k = 0; k < 8; ++k) fill(first + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2), rest_pose_point);
  }

 private:
  template <class RestPose>
  void fill(glm::ivec3 at, const RestPose& rest_pose_point) {
    at = glm::clamp(at, glm::ivec3(0), volume_.size - 1);
    const auto cell =
        (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(volume_.size.y) + static_cast<std::size_t>(at.y)) *
            static_cast<std::size_t>(volume_.size.x) +
        static_cast<std::size_t>(at.x);
    if (filled_[cell]) return;
    filled_[cell] = true;
    const glm::vec3 middle = volume_.origin + (glm::vec3(at) + 0.5f) * volume_.cell;
    const glm::vec4 value = glm::clamp(value_(rest_pose_point(middle)), 0.0f, 1.0f);
    for (int k = 0; k < 4; ++k)
      volume_.rgba[4 * cell + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * value[k]));
  }

  const VolumeValue& value_;
  SurfaceVolume& volume_;
  std::vector<bool> filled_;
};

/// Calls `visit` with barycentric coordinates at most `spacing` apart over a triangle.
template <class Visit>
void for_each_point(const std::array<glm::vec3, 3>& corners, float spacing, Visit visit) {
  const auto& [a, b, c] = corners;
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

glm::vec3 mixed(const std::array<glm::vec3, 3>& values, glm::vec3 share) {
  return share.x * values[0] + share.y * values[1] + share.z * values[2];
}

/// A triangle in the current pose and in the rest pose.
struct Corners {
  std::array<glm::vec3, 3> positions, rest_pose_positions, rest_normals;
  bool moved = false;
  glm::mat3 rotation{1};

  Corners(const VolumeSurface& surface, const glm::uvec3& t) : moved(!surface.rest_positions.empty()) {
    const auto of = [&](std::span<const glm::vec3> values) {
      return std::array{values[t.x], values[t.y], values[t.z]};
    };
    positions = of(surface.positions);
    rest_pose_positions = of(moved ? surface.rest_positions : surface.positions);
    rest_normals = of(moved ? surface.rest_normals : surface.normals);
    if (moved) rotation = rotation_of_triangle(rest_pose_positions, positions);
  }

  RestPosePoint rest_pose_point(glm::vec3 share) const {
    const glm::vec3 normal = mixed(rest_normals, share);
    const float length = glm::length(normal);
    return {mixed(rest_pose_positions, share), length > 0 ? normal / length : rest_normals[0], rotation};
  }
};

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
    const Corners corners(surface, t);
    for_each_point(corners.positions, 0.5f * volume.cell, [&](glm::vec3 share) {
      const RestPosePoint rest = corners.rest_pose_point(share);
      const glm::vec3 position = mixed(corners.positions, share);
      filler.fill_about(position, [&](glm::vec3 middle) {
        if (!corners.moved) return RestPosePoint{middle, rest.normal};
        return RestPosePoint{rest.position + glm::transpose(rest.rotation) * (middle - position), rest.normal,
                             rest.rotation};
      });
    });
  }
  return volume;
}

}  // namespace pelage
