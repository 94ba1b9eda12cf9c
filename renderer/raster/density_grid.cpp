#include "renderer/raster/density_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "protocol/base/parallel.h"

namespace pelage {

namespace {

constexpr float finest_cell = 0.008f;  // sizes
constexpr double max_cells = 1 << 20;
constexpr double cells_a_step = 4;
constexpr int max_steps = 4096;  // of a segment, so that fur of any length ends

GridPlace place_around(std::span<const GrownPart> parts) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const GrownPart& part : parts) {
    if (part.role != StrandRole::coat || part.strands->count() == 0) continue;
    low = glm::min(low, part.low), high = glm::max(high, part.high);
  }
  if (low.x > high.x) return {};
  const glm::dvec3 room(high - low);
  const double cell = std::max(double{finest_cell}, std::cbrt(room.x * room.y * room.z / max_cells));
  // In steps of some cells, so that a stroke seldom moves it.
  const glm::dvec3 first = glm::floor((glm::dvec3(low) / cell - 1.0) / cells_a_step) * cells_a_step;
  const glm::dvec3 last = glm::ceil((glm::dvec3(high) / cell + 1.0) / cells_a_step) * cells_a_step;
  return {glm::vec3(first * cell), static_cast<float>(cell), glm::ivec3(last - first)};
}

/// To sums that several threads add to: `sign` is -1 for what goes.
void add(CellDensity& density, float covered, glm::vec3 way, int sign) {
  const std::array values{covered, way.x, way.y, way.z};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto fixed = static_cast<std::int32_t>(std::lround(values[i] * CellDensity::one));
    std::atomic_ref(density.sum[i]).fetch_add(sign * fixed, std::memory_order_relaxed);
  }
}

void add_segment(const GridPlace& place, const StrandPoint& a, const StrandPoint& b, int sign,
                 std::vector<CellDensity>& cells) {
  const glm::vec3 way = b.place - a.place;
  const float length = glm::length(way);
  const int steps = std::clamp(static_cast<int>(std::min(std::ceil(length / place.cell), 1e6f)), 1, max_steps);
  const float width = (a.radius + b.radius) / (place.cell * place.cell * static_cast<float>(steps));
  for (int s = 0; s < steps; ++s) {
    const glm::vec3 at = a.place + way * ((static_cast<float>(s) + 0.5f) / static_cast<float>(steps));
    const glm::ivec3 cell = glm::clamp(glm::ivec3((at - place.low) / place.cell), glm::ivec3(0), place.size - 1);
    add(cells[place.index(cell)], width * length, width * way, sign);
  }
}

void add_strands(const GridPlace& place, const StrandSet& set, int sign, std::vector<CellDensity>& cells) {
  const auto knots = static_cast<std::size_t>(set.segments) + 1;
  for (std::size_t k = 0; k + 1 < set.points.size(); ++k)
    if (k % knots + 1 < knots) add_segment(place, set.points[k], set.points[k + 1], sign, cells);
}

}  // namespace

/// Sums are whole numbers, so that taking strands out leaves what would be there without them.
bool DensityGrid::add_fur(std::span<const GrownPart> parts, int threads) {
  const GridPlace around = place_around(parts);
  if (!(around == place_) || held_.size() != parts.size()) {
    place_ = around;
    density_.assign(place_.count(), {}), held_.assign(parts.size(), nullptr);
  }
  std::vector<std::uint32_t> changed;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (parts[p].role == StrandRole::coat && parts[p].strands != held_[p]) changed.push_back(p);
  for_each_in_parallel(
      static_cast<std::uint32_t>(changed.size()),
      [&](std::uint32_t i) {
        auto& held = held_[changed[i]];
        if (held) add_strands(place_, *held, -1, density_);
        held = parts[changed[i]].strands;
        add_strands(place_, *held, 1, density_);
      },
      threads);
  return !changed.empty();
}

void DensityGrid::update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights,
                         int threads) {
  const bool grown = add_fur(parts, threads), changed = grown || model.id != model_;
  if (changed) ++changes_;
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (changed || i >= lights_.size() || !(lights_[i] == lights[i])) moved.push_back(i);
  model_ = model.id;
  lights_.assign(lights.begin(), lights.end());
  crossed_.resize((lights.size() + 1) / 2);
  for (std::vector<CrossedByTwo>& pair : crossed_) pair.resize(place_.count());
  for_each_in_parallel(
      static_cast<std::uint32_t>(moved.size()),
      [&](std::uint32_t i) {
        const std::size_t light = moved[i];
        const std::vector<Crossed> cells = light_cells(place_, density_, model, lights[light]);
        for (std::size_t at = 0; at < cells.size(); ++at) crossed_[light / 2][at][light % 2] = cells[at];
      },
      threads);
}

std::size_t DensityGrid::bytes() const {
  return density_.size() * sizeof(CellDensity) + crossed_.size() * place_.count() * sizeof(CrossedByTwo);
}

}  // namespace pelage
