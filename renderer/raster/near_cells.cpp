#include "renderer/raster/near_cells.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "renderer/raster/kernels.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

namespace {

constexpr float over_cell = 5;                           // near cells along a side of a cell of the density grid
constexpr float around_part = 0.015f, in_depth = 0.15f;  // margin of a part; depth of what counts as near; sizes

/// Returns the distance of a part's middle along the view.
float distance_of(const RasterScene& scene, const GrownPart& part) {
  return glm::dot(part.middle - scene.camera.position, scene.camera.forward);
}

/// Returns whether a part's skin is near enough, and in the picture or just outside it. Depends on the skin alone, so
/// that strokes do not change it.
bool is_near(const RasterScene& scene, const GrownPart& part) {
  const PictureCamera& camera = scene.camera;
  const glm::vec3 apart = part.middle - camera.position;
  const float distance = distance_of(scene, part), reach = part.radius + around_part;
  const auto across = static_cast<float>(std::max(scene.width, scene.height));
  if (distance < -reach || std::max(distance - reach, 0.0f) * across > static_cast<float>(near_no_view) * camera.scale)
    return false;
  if (distance < 2 * reach) return true;
  const float pixels = 1.5f * reach * camera.scale / distance;  // with room for perspective away from the centre
  const glm::vec2 off = camera.scale / distance * glm::vec2(glm::dot(apart, camera.right), glm::dot(apart, camera.up));
  return std::abs(off.x) < 0.5f * static_cast<float>(scene.width) + pixels &&
         std::abs(off.y) < 0.5f * static_cast<float>(scene.height) + pixels;
}

std::uint32_t index_of(glm::vec3 cells) {
  const auto to_index = [](float v) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v))); };
  return (to_index(cells.x) * std::uint32_t{near_of_x} ^ to_index(cells.y) * std::uint32_t{near_of_y} ^
          to_index(cells.z) * std::uint32_t{near_of_z}) &
         (NearCells::count - 1);
}

void add_to_cells(std::span<const StrandPoint> points, float cell, std::vector<std::uint16_t>& cells) {
  const float over = 1 / cell;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const StrandPoint &a = points[k - 1], &b = points[k];
    const glm::vec3 segment = b.position - a.position;
    const float length = glm::length(segment);
    const float steps = std::clamp(std::ceil(length * over), 1.0f, 1024.0f), step = 1 / steps;
    const float covered = NearCells::one * (a.radius + b.radius) * length * over * over * step;
    const auto added = static_cast<std::uint16_t>(std::clamp(covered, 0.0f, max_near_step) + 0.5f);
    for (float s = 0.5f; s < steps; ++s) {
      const glm::vec3 at = glm::clamp((a.position + segment * (s * step)) * over, glm::vec3(-1e9f), glm::vec3(1e9f));
      std::atomic_ref(cells[index_of(at)]).fetch_add(added, std::memory_order_relaxed);
    }
  }
}

}  // namespace

// Leaves out parts that are far behind the nearest one.
std::vector<std::uint32_t> near_parts(const RasterScene& scene) {
  std::vector<std::uint32_t> parts;
  float nearest = 1e9f;
  for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
    if (scene.parts[i].role != StrandRole::coat || !is_near(scene, scene.parts[i])) continue;
    parts.push_back(i), nearest = std::min(nearest, distance_of(scene, scene.parts[i]));
  }
  std::erase_if(
      parts, [&](std::uint32_t i) { return distance_of(scene, scene.parts[i]) > std::max(nearest, 0.0f) + in_depth; });
  return parts;
}

float near_cell_side(float cell) { return cell / over_cell; }

void NearCells::fill(int threads) {
  cells_.assign(strands_.empty() ? 0 : count + 1, 0);  // one more: lookups read pairs
  for_each_in_parallel(
      static_cast<std::uint32_t>(strands_.size()),
      [&](std::uint32_t i) {
        const StrandSet& set = *strands_[i];
        const auto knots = static_cast<std::size_t>(set.segments) + 1;
        for (std::size_t k = 0; k < set.points.size(); k += knots)
          add_to_cells(std::span(set.points).subspan(k, knots), cell_, cells_);
      },
      threads);
  mean_ = static_cast<float>(std::accumulate(cells_.begin(), cells_.end(), std::uint64_t{0})) / count;
}

void NearCells::update(const RasterScene& scene, std::uint64_t version, int threads) {
  std::vector<std::uint32_t> parts = near_parts(scene);
  std::vector<std::shared_ptr<const StrandSet>> sets;
  for (const std::uint32_t i : parts) sets.push_back(scene.parts[i].strands);
  const float cell = near_cell_side(scene.cells->cell);
  if (parts == parts_ && cell_ == cell && sets == strands_) return;
  since_ = version;
  cell_ = cell, parts_ = std::move(parts), strands_ = std::move(sets);
  fill(threads);
}

}  // namespace pelage
