#include "renderer/raster/density_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "protocol/base/parallel.h"

namespace pelage {

namespace {

constexpr float finest_cell = 0.008f;  // sizes
constexpr double max_cells = 1 << 20, max_side = 1 << 10;
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
  const double longest = std::max({room.x, room.y, room.z});
  const double cell =
      std::max({double{finest_cell}, std::cbrt(room.x * room.y * room.z / max_cells), longest / max_side});
  // In steps of some cells, so that a stroke seldom moves it.
  const glm::dvec3 first = glm::floor((glm::dvec3(low) / cell - 1.0) / cells_a_step) * cells_a_step;
  const glm::dvec3 last = glm::ceil((glm::dvec3(high) / cell + 1.0) / cells_a_step) * cells_a_step;
  return {glm::vec3(first * cell), static_cast<float>(cell), glm::ivec3(last - first)};
}

/// Sums over the cells that a part's strands may stand in, of one thread alone.
class PartCells {
 public:
  PartCells(const GridPlace& place, const GrownPart& part) : place_(place) {
    const auto cell_of = [&](glm::vec3 at) {
      return glm::clamp(glm::ivec3(glm::floor((at - place.low) / place.cell)), glm::ivec3(0), place.size - 1);
    };
    first_ = cell_of(part.low), size_ = cell_of(part.high) - first_ + 1;
    sums_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                 static_cast<std::size_t>(size_.z));
    add_strands(*part.strands);
  }

  /// Adds them to the grid's, which several threads do at a time: `sign` is -1 for what goes.
  void add_to(std::vector<CellDensity>& cells, int sign) const {
    std::size_t at = 0;
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x, ++at) {
          if (sums_[at].sum[0] == 0) continue;
          CellDensity& cell = cells[place_.index(first_ + glm::ivec3(x, y, z))];
          for (std::size_t i = 0; i < cell.sum.size(); ++i)
            std::atomic_ref(cell.sum[i]).fetch_add(sign * sums_[at].sum[i], std::memory_order_relaxed);
        }
  }

 private:
  void add_strands(const StrandSet& set) {
    const auto knots = static_cast<std::size_t>(set.segments) + 1;
    for (std::size_t k = 0; k + 1 < set.points.size(); ++k)
      if (k % knots + 1 < knots) add_segment(set.points[k], set.points[k + 1]);
  }

  void add_segment(const StrandPoint& a, const StrandPoint& b) {
    const glm::vec3 way = b.place - a.place;
    const float length = glm::length(way), over = 1 / place_.cell;
    const int steps = std::clamp(static_cast<int>(std::min(std::ceil(length * over), 1e6f)), 1, max_steps);
    const float width = CellDensity::one * (a.radius + b.radius) * over * over / static_cast<float>(steps);
    const auto whole = [](float v) {
      constexpr float largest = 1e10f;  // a hundred million of them can be added
      return static_cast<std::int64_t>(std::max(-largest, std::min(largest, v)) + (v < 0 ? -0.5f : 0.5f));
    };
    const std::array<std::int64_t, 4> added{whole(width * length), whole(width * way.x), whole(width * way.y),
                                            whole(width * way.z)};
    for (int s = 0; s < steps; ++s) {
      const glm::vec3 at = a.place + way * ((static_cast<float>(s) + 0.5f) / static_cast<float>(steps));
      const glm::ivec3 cell = glm::clamp(glm::ivec3((at - place_.low) * over) - first_, glm::ivec3(0), size_ - 1);
      CellDensity& density = sums_[(static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size_.y) +
                                    static_cast<std::size_t>(cell.y)) *
                                       static_cast<std::size_t>(size_.x) +
                                   static_cast<std::size_t>(cell.x)];
      for (std::size_t i = 0; i < added.size(); ++i) density.sum[i] += added[i];
    }
  }

  const GridPlace& place_;
  glm::ivec3 first_{0}, size_{1};
  std::vector<CellDensity> sums_;
};

}  // namespace

/// Sums are whole numbers, so that taking strands out leaves what would be there without them.
bool DensityGrid::add_fur(std::span<const GrownPart> parts, int threads) {
  const GridPlace around = place_around(parts);
  if (!(around == place_) || held_.size() != parts.size()) {
    place_ = around;
    density_.assign(place_.count(), {}), held_.assign(parts.size(), {});
  }
  std::vector<std::uint32_t> changed;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (parts[p].role == StrandRole::coat && parts[p].strands != held_[p].strands) changed.push_back(p);
  for_each_in_parallel(
      static_cast<std::uint32_t>(changed.size()),
      [&](std::uint32_t i) {
        GrownPart& held = held_[changed[i]];
        if (held.strands) PartCells(place_, held).add_to(density_, -1);
        held = parts[changed[i]];
        PartCells(place_, held).add_to(density_, 1);
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
