#include "renderer/raster/density_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace pelage {

namespace {

constexpr float finest_cell = 0.008f;  // sizes
constexpr double max_cells = 1 << 20, max_side = 1 << 10;
constexpr double cells_a_step = 4;

/// A box of cells.
struct CellBox {
  glm::ivec3 first{0}, size{1};
};

/// Returns the cells that a box touches.
CellBox cells_of(const GridLayout& layout, glm::vec3 low, glm::vec3 high) {
  const auto cell_of = [&](glm::vec3 at) {
    return glm::clamp(glm::ivec3(glm::floor((at - layout.low) / layout.cell)), glm::ivec3(0), layout.size - 1);
  };
  const glm::ivec3 first = cell_of(low);
  return {first, cell_of(high) - first + 1};
}

/// Numbers of some strands of a part.
using StrandIds = std::vector<std::uint32_t>;

/// Returns the strands that differ between two sets of the same size.
StrandIds changed_strands(const StrandSet& a, const StrandSet& b) {
  StrandIds ids;
  const auto knots = static_cast<std::size_t>(a.segments) + 1;
  const auto same = [](const auto& one, const auto& other, std::size_t first, std::size_t count) {
    return std::memcmp(&one[first], &other[first], count * sizeof(one[0])) == 0;
  };
  for (std::uint32_t i = 0; i < a.count(); ++i)
    if (!same(a.points, b.points, i * knots, knots) || !same(a.colours, b.colours, i * knots, knots) ||
        !same(a.roots, b.roots, i, 1) || (!a.to_mean.empty() && a.to_mean[i] != b.to_mean[i]))
      ids.push_back(i);
  return ids;
}

/// Returns whether keep_strands keeps the same strands of both states of a part, and widens them alike.
bool keeps_as(const GrownPart& a, const GrownPart& b) {
  const StrandSet &one = *a.strands, &other = *b.strands;
  if (one.count() != other.count() || one.segments != other.segments || a.longest != b.longest) return false;
  return one.count() == 0 || one.points[0].radius == other.points[0].radius;
}

/// How a part differs from its state in the grid.
struct PartChange {
  std::uint32_t part = 0;
  StrandIds ids;                  // strands that differ, unless `all`
  bool all = true, skin = true;   // all of its strands have changed; the look of its skin has
  std::vector<glm::ivec3> cells;  // cells of the strands that changed, before and after

  PartChange(std::uint32_t number, const GrownPart& stored, const GrownPart& now)
      : part(number), skin(stored.skin != now.skin) {
    if (!stored.strands || !keeps_as(stored, now)) return;
    ids = changed_strands(*stored.strands, *now.strands), all = ids.size() == now.strands->count();
  }
};

/// Returns the share of a strand that stops light as if it lay alone: the turns of a curl shadow each other and the
/// turns of the strands that curl with it. 1 for a straight strand.
float exposed_share(std::span<const StrandPoint> points) {
  float path = 0;
  for (std::size_t k = 1; k < points.size(); ++k) path += glm::distance(points[k - 1].position, points[k].position);
  const float reach = glm::distance(points.front().position, points.back().position);
  return 1 / (1 + curl_in_shadow * std::max(path / std::max(reach, 0.02f * path + 1e-9f) - 1, 0.0f));
}

/// Sums of one thread over the cells of one part at a time, before they are added to the grid.
class PartCells {
 public:
  /// `named`: add() also returns the cells that any strand touches, even one that is not summed.
  PartCells(const GridLayout& layout, bool named) : layout_(layout), named_(named) {}

  /// Adds the strands of a change to the grid's cells; several threads may do this at a time. `sign` is -1 for strands
  /// that are removed. With `named`, appends the cells that they touch to `touched`.
  void add(const GrownPart& part, const PartChange& change, int sign, std::vector<CellDensity>& cells,
           std::vector<glm::ivec3>& touched) {
    const CellBox box = cells_of(layout_, part.low, part.high);
    first_ = box.first, size_ = box.size;
    const auto count =
        static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(size_.z);
    if (sums_.size() < count) sums_.resize(count), on_.resize(count);
    const auto all = static_cast<std::uint32_t>(part.strands->count()), summed = summed_strands(part, layout_.cell);
    const float each = static_cast<float>(all) / static_cast<float>(std::max(summed, 1u));
    const auto add = [&](std::uint32_t id) { add_strand(*part.strands, id, id < summed ? each : 0); };
    if (change.all) {
      for (std::uint32_t id = 0; id < (named_ ? all : summed); ++id) add(id);
    } else {
      for (const std::uint32_t id : change.ids) add(id);
    }
    hand_over(sign, cells, touched);
  }

 private:
  void add_strand(const StrandSet& set, std::uint32_t id, float weight) {
    const auto segments = static_cast<std::size_t>(set.segments), first = id * (segments + 1);
    const float share = weight * exposed_share(std::span(set.points).subspan(first, segments + 1));
    for (std::size_t k = first; k < first + segments; ++k) add_segment(set.points[k], set.points[k + 1], share);
  }

  void add_segment(const StrandPoint& a, const StrandPoint& b, float share) {
    const glm::vec3 path = b.position - a.position;
    const float length = glm::length(path), over = 1 / layout_.cell;
    const int steps = std::clamp(static_cast<int>(std::min(std::ceil(length * over), 1e6f)), 1, max_segment_steps);
    const float step = 1 / static_cast<float>(steps);
    const float width = share * CellDensity::one * (a.radius + b.radius) * over * over * step;
    const auto to_fixed = [](float v) {
      constexpr float largest = 1e10f;  // a hundred million such terms fit into 64 bits
      return static_cast<std::int64_t>(std::max(-largest, std::min(largest, v)) + std::copysign(0.5f, v));
    };
    const std::int64_t along = to_fixed(width * length);
    const std::int64_t x = to_fixed(width * path.x), y = to_fixed(width * path.y), z = to_fixed(width * path.z);
    for (int s = 0; s < steps; ++s) {
      const glm::vec3 at = a.position + path * ((static_cast<float>(s) + 0.5f) * step);
      std::array<std::int64_t, 4>& sum = sums_[index_of(at, over)].sum;
      sum[0] += along, sum[1] += x, sum[2] += y, sum[3] += z;
    }
  }

  std::uint32_t index_of(glm::vec3 at, float over) {
    const glm::ivec3 cell = glm::clamp(glm::ivec3((at - layout_.low) * over) - first_, glm::ivec3(0), size_ - 1);
    const auto index = static_cast<std::uint32_t>((cell.z * size_.y + cell.y) * size_.x + cell.x);
    if (!on_[index]) on_[index] = 1, touched_.push_back(index);
    return index;
  }

  void hand_over(int sign, std::vector<CellDensity>& cells, std::vector<glm::ivec3>& touched) {
    for (const std::uint32_t index : touched_) {
      const int at = static_cast<int>(index), across = size_.x, down = size_.y;
      const glm::ivec3 position = first_ + glm::ivec3(at % across, at / across % down, at / (across * down));
      if (named_) touched.push_back(position);
      CellDensity& cell = cells[layout_.index(position)];
      const CellDensity sums = std::exchange(sums_[index], {});
      for (std::size_t i = 0; i < cell.sum.size(); ++i)
        std::atomic_ref(cell.sum[i]).fetch_add(sign * sums.sum[i], std::memory_order_relaxed);
      on_[index] = 0;
    }
    touched_.clear();
  }

  const GridLayout& layout_;
  bool named_;
  glm::ivec3 first_{0}, size_{1};
  std::vector<CellDensity> sums_;  // for each cell of the part's box; all 0 between parts
  std::vector<std::uint8_t> on_;   // for each of these cells, whether it is in touched_
  std::vector<std::uint32_t> touched_;
};

}  // namespace

GridLayout grid_layout(std::span<const GrownPart> parts) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const GrownPart& part : parts) {
    if (part.role != StrandRole::coat) continue;
    low = glm::min(low, part.low), high = glm::max(high, part.high);
  }
  if (low.x > high.x) return {};
  const glm::dvec3 extent(high - low);
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double cell =
      std::max({double{finest_cell}, std::cbrt(extent.x * extent.y * extent.z / max_cells), longest / max_side});
  // The grid's corners lie on multiples of some cells, so that a stroke seldom moves the grid.
  const glm::dvec3 first = glm::floor((glm::dvec3(low) / cell - 1.0) / cells_a_step) * cells_a_step;
  const glm::dvec3 last = glm::ceil((glm::dvec3(high) / cell + 1.0) / cells_a_step) * cells_a_step;
  return {glm::vec3(first * cell), static_cast<float>(cell), glm::ivec3(last - first)};
}

std::uint32_t summed_strands(const GrownPart& part, float cell) {
  constexpr double enough = 8;
  const double count = static_cast<double>(part.strands->count());
  const double on_cell = count * cell * cell / std::max(part.area, 1e-12);
  return static_cast<std::uint32_t>(std::ceil(count * std::min(1.0, enough / std::max(on_cell, 1e-9))));
}

template <class Use>
void DensityGrid::each_block(glm::ivec3 first, glm::ivec3 last, const Use& use) {
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) use(glm::ivec3(x, y, z));
}

void DensityGrid::reset(const GridLayout& layout, std::size_t parts) {
  layout_ = layout;
  density_.assign(layout_.count(), {}), summed_parts_.assign(parts, {});
  lights_.clear();
  blocks_ = (layout_.size + block_side - 1) / block_side;
  const auto count =
      static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y) * static_cast<std::size_t>(blocks_.z);
  of_block_.assign(count, 0), fur_of_block_.assign(count, 0), has_skin_.assign(count, 0);
}

void DensityGrid::find_skin(const FurModel& model) {
  std::fill(has_skin_.begin(), has_skin_.end(), std::uint8_t{0});
  for (const glm::uvec3& t : model.triangles) {
    const glm::vec3 a = model.positions[t.x], b = model.positions[t.y], c = model.positions[t.z];
    each_block(block_of(glm::min(a, glm::min(b, c))), block_of(glm::max(a, glm::max(b, c))),
               [&](glm::ivec3 block) { has_skin_[block_at(block)] = 1; });
  }
}

std::vector<std::uint32_t> DensityGrid::changed_parts(std::span<const GrownPart> parts) const {
  std::vector<std::uint32_t> others;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (parts[p].role == StrandRole::coat && parts[p].strands != summed_parts_[p].strands) others.push_back(p);
  return others;
}

/// Empties the grid: when most parts have changed, that costs less than to subtract the strands that changed.
void DensityGrid::clear_fur() {
  std::fill(density_.begin(), density_.end(), CellDensity());
  std::fill(summed_parts_.begin(), summed_parts_.end(), GrownPart());
  rebuilt_version_ = version_;
}

/// Subtracts the strands that changed and adds their new state. Sums are integers, so that this is exact.
CellRows DensityGrid::add_fur(std::span<const GrownPart> parts, int threads) {
  std::vector<std::uint32_t> others = changed_parts(parts);
  if (others.empty()) return {};
  if (2 * others.size() > parts.size()) clear_fur(), others = changed_parts(parts);
  std::vector<PartChange> changes;
  for (const std::uint32_t p : others) changes.emplace_back(p, summed_parts_[p], parts[p]);
  std::atomic<std::size_t> next{0};
  run_on_threads(threads, [&] {
    PartCells cells(layout_, rebuilt_version_ < version_);
    for (std::size_t i = next++; i < changes.size(); i = next++) {
      PartChange& change = changes[i];
      GrownPart& stored = summed_parts_[change.part];
      if (stored.strands) cells.add(stored, change, -1, density_, change.cells);
      stored = parts[change.part];
      cells.add(stored, change, 1, density_, change.cells);
    }
  });
  if (rebuilt_version_ == version_) return CellRows(layout_.rows(), {0, layout_.size.x});
  CellRows rows(layout_.rows());
  for (const PartChange& change : changes) {
    mark_fur(change.cells, rows);
    if (change.skin) mark_skin(parts[change.part]);
  }
  return rows;
}

/// Marks changed cells in `rows`, and their blocks. Also marks the blocks of neighbouring cells: an end of a strand may
/// lie in the cell beside the one in which it was counted.
void DensityGrid::mark_fur(std::span<const glm::ivec3> cells, CellRows& rows) {
  for (const glm::ivec3& cell : cells) {
    rows[layout_.row(cell.y, cell.z)].add({cell.x, cell.x + 1});
    const glm::ivec3 first = glm::max(cell - 1, glm::ivec3(0)), last = glm::min(cell + 1, layout_.size - 1);
    each_block(first / block_side, last / block_side,
               [&](glm::ivec3 block) { of_block_[block_at(block)] = fur_of_block_[block_at(block)] = version_; });
  }
}

void DensityGrid::mark_skin(const GrownPart& part) {
  each_block(block_of(part.low), block_of(part.high), [&](glm::ivec3 block) { of_block_[block_at(block)] = version_; });
}

/// Marks the blocks of changed cells and of their neighbours: lookups interpolate between the middles of several cells,
/// at a position slightly off the skin.
void DensityGrid::mark_light(std::span<const std::uint32_t> cells) {
  constexpr int beside = 2;
  for (const std::uint32_t index : cells) {
    const glm::ivec3 cell = layout_.cell_of(index);
    each_block(glm::max(cell - beside, glm::ivec3(0)) / block_side,
               glm::min(cell + beside, layout_.size - 1) / block_side,
               [&](glm::ivec3 block) { of_block_[block_at(block)] = version_; });
  }
}

void DensityGrid::update_lights(const FurModel& model, std::span<const FurLight> lights, const CellRows& changed,
                                int threads) {
  std::vector<std::vector<std::uint32_t>> cells(lights.size());
  std::vector<std::optional<LightCells>> made(lights.size());
  const auto known = [&](std::size_t i) {
    return i < lights_.size() && model.id == model_ && lights_[i].light() == lights[i];
  };
  for_each_in_parallel(
      static_cast<std::uint32_t>(lights.size()),
      [&](std::uint32_t i) {
        if (!known(i))
          made[i].emplace(layout_, density_, model, lights[i]);
        else if (!changed.empty())
          cells[i] = lights_[i].update(density_, changed);
      },
      threads);
  lights_.erase(lights_.begin() + static_cast<std::ptrdiff_t>(std::min(lights.size(), lights_.size())), lights_.end());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (made[i] || !cells[i].empty()) crossed_version_ = version_;
    if (made[i]) {
      if (i == lights_.size())
        lights_.push_back(std::move(*made[i]));
      else
        lights_[i] = std::move(*made[i]);
      rebuilt_version_ = version_;
    } else if (rebuilt_version_ < version_) {
      mark_light(cells[i]);
    }
  }
  model_ = model.id;
}

void DensityGrid::update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights,
                         int threads) {
  ++version_;
  if (const GridLayout around = grid_layout(parts); !(around == layout_) || summed_parts_.size() != parts.size()) {
    reset(around, parts.size());
    rebuilt_version_ = version_;
  }
  if (rebuilt_version_ == version_ || model.id != model_) find_skin(model);
  const CellRows changed = add_fur(parts, threads);
  if (!changed.empty()) fur_version_ = version_;
  update_lights(model, lights, changed, threads);
}

glm::ivec3 DensityGrid::block_of(glm::vec3 position) const {
  const glm::ivec3 block(glm::floor((position - layout_.low) / (layout_.cell * block_side)));
  return glm::clamp(block, glm::ivec3(0), blocks_ - 1);
}

bool DensityGrid::changed_in(glm::vec3 low, glm::vec3 high, std::uint64_t since) const {
  bool changed = false;
  each_block(block_of(low), block_of(high), [&](glm::ivec3 block) { changed |= of_block_[block_at(block)] > since; });
  return changed;
}

std::vector<std::int32_t> DensityGrid::changed_flags(std::uint64_t since) const {
  std::vector<std::int32_t> flags(of_block_.size());
  std::transform(of_block_.begin(), of_block_.end(), fur_of_block_.begin(), flags.begin(),
                 [since](std::uint64_t any, std::uint64_t fur) {
                   return (any > since ? light_changed : 0) | (fur > since ? fur_changed : 0);
                 });
  return flags;
}

std::vector<GridBlock> DensityGrid::changed_blocks(std::uint64_t since) const {
  std::vector<GridBlock> changed;
  const float side = layout_.cell * block_side;
  each_block(glm::ivec3(0), blocks_ - 1, [&](glm::ivec3 block) {
    const std::size_t at = block_at(block);
    if (fur_of_block_[at] <= since && !(has_skin_[at] && of_block_[at] > since)) return;
    const glm::vec3 low = layout_.low + side * glm::vec3(block);
    changed.push_back({low, low + side, fur_of_block_[at] > since});
  });
  return changed;
}

std::size_t DensityGrid::bytes() const {
  std::size_t bytes = density_.size() * sizeof(CellDensity);
  for (const LightCells& light : lights_) bytes += light.bytes();
  return bytes;
}

}  // namespace pelage
