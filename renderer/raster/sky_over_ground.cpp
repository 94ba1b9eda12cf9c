#include "renderer/raster/sky_over_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/parallel.h"

namespace pelage {

namespace {

constexpr float reach = 0.3f;     // how far the map extends beyond the grid, sizes
constexpr float finest = 0.02f;   // smallest distance between entries of the map, sizes
constexpr int max_entries = 128;  // entries of the map along each side
constexpr float nowhere = std::numeric_limits<float>::max();

/// The lowest and the highest point of fur and skin in a column of the grid, sizes; empty if low is above high.
struct Column {
  float low = nowhere, high = -nowhere;
  void add(float bottom, float top) { low = std::min(low, bottom), high = std::max(high, top); }
};

class Columns {
 public:
  Columns(const GridLayout& layout, std::span<const CellDensity> density, const FurModel& model)
      : layout_(layout), columns_(static_cast<std::size_t>(layout.size.x) * static_cast<std::size_t>(layout.size.z)) {
    add_fur(density);
    for (const glm::uvec3& t : model.triangles)
      add_skin(model.positions[t.x], model.positions[t.y], model.positions[t.z]);
    for (const Column& column : columns_) top_ = std::max(top_, column.high);
  }

  float top() const { return top_; }

  /// Returns whether a ray hits any column. `from` lies below the columns' tops, and `direction` points up.
  bool stop(glm::vec3 from, glm::vec3 direction) const {
    const glm::vec3 low = layout_.low, high = low + layout_.cell * glm::vec3(layout_.size);
    float begin = 0, end = (top_ - from.y) / direction.y;
    for (const int axis : {0, 2}) {
      const float over = 1 / (std::abs(direction[axis]) > 1e-6f ? direction[axis] : 1e-6f);
      const float a = (low[axis] - from[axis]) * over, b = (high[axis] - from[axis]) * over;
      begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
    }
    const float step = 2 * layout_.cell;
    for (float t = begin + 0.5f * step; t < end; t += step) {
      const glm::vec3 at = from + t * direction;
      const Column& column = columns_[column_of(at)];
      if (at.y >= column.low && at.y <= column.high) return true;
    }
    return false;
  }

 private:
  std::size_t column_of(glm::vec3 at) const {
    const glm::vec3 cell = glm::clamp((at - layout_.low) / layout_.cell, glm::vec3(0), glm::vec3(layout_.size) - 0.5f);
    return static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(layout_.size.x) +
           static_cast<std::size_t>(cell.x);
  }

  void add_fur(std::span<const CellDensity> density) {
    std::size_t at = 0;
    for (int z = 0; z < layout_.size.z; ++z) {
      for (int y = 0; y < layout_.size.y; ++y) {
        const float bottom = layout_.low.y + layout_.cell * static_cast<float>(y);
        for (int x = 0; x < layout_.size.x; ++x, ++at) {
          if (static_cast<float>(density[at].sum[0]) < solid_strands * CellDensity::one) continue;
          columns_[static_cast<std::size_t>(z) * static_cast<std::size_t>(layout_.size.x) + static_cast<std::size_t>(x)]
              .add(bottom, bottom + layout_.cell);
        }
      }
    }
  }

  void add_skin(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const float longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (longest > 1.5f * layout_.cell) {
      const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
      add_skin(a, ab, ca), add_skin(ab, b, bc), add_skin(ca, bc, c), add_skin(ab, bc, ca);
      return;
    }
    const glm::vec3 middle = (a + b + c) / 3.0f;
    columns_[column_of(middle)].add(middle.y, middle.y);
  }

  const GridLayout& layout_;
  std::vector<Column> columns_;  // index: z times size.x, plus x
  float top_ = -nowhere;
};

/// Returns cosine-weighted directions of a uniform sky: a spiral on the disc (Vogel 1979), lifted to the hemisphere.
std::array<glm::vec3, sky_directions> directions_over_ground() {
  std::array<glm::vec3, sky_directions> all;
  for (int i = 0; i < sky_directions; ++i) {
    const float square = (static_cast<float>(i) + 0.5f) / sky_directions, angle = 2.399963f * static_cast<float>(i);
    all[static_cast<std::size_t>(i)] = {std::sqrt(square) * std::cos(angle), std::sqrt(1 - square),
                                        std::sqrt(square) * std::sin(angle)};
  }
  return all;
}

}  // namespace

SkyOverGround sky_map(const GridLayout& layout) {
  const glm::vec2 low(layout.low.x, layout.low.z), extent(layout.cell * glm::vec2(layout.size.x, layout.size.z));
  SkyOverGround map;
  map.low = low - reach;
  map.cell = std::max(finest, (std::max(extent.x, extent.y) + 2 * reach) / (max_entries - 1));
  map.size = glm::ivec2(glm::ceil((extent + 2 * reach) / map.cell)) + 1;
  return map;
}

SkyOverGround sky_over_ground(const GridLayout& layout, std::span<const CellDensity> density, const FurModel& model,
                              float height, int threads) {
  const Columns columns(layout, density, model);
  if (!(columns.top() > height)) return {};
  const std::array<glm::vec3, sky_directions> all = directions_over_ground();
  SkyOverGround map = sky_map(layout);
  map.hidden.resize(static_cast<std::size_t>(map.size.x) * static_cast<std::size_t>(map.size.y));
  for_each_in_parallel(
      static_cast<std::uint32_t>(map.size.y),
      [&](std::uint32_t row) {
        for (int i = 0; i < map.size.x; ++i) {
          const glm::vec2 at = map.low + map.cell * glm::vec2(i, row);
          const auto stopped = std::count_if(all.begin(), all.end(), [&](const glm::vec3& direction) {
            return columns.stop({at.x, height, at.y}, direction);
          });
          map.hidden[row * static_cast<std::size_t>(map.size.x) + static_cast<std::size_t>(i)] =
              static_cast<float>(stopped) / sky_directions;
        }
      },
      threads);
  return map;
}

}  // namespace pelage
