#include "renderer/raster/light_cells.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "renderer/raster/kernels.h"

namespace pelage {

namespace {

/// Adds the area of a triangle, as projected along the light's rays, to the cells in which it lies. `away`: that area.
void add_skin(const GridLayout& layout, glm::vec3 a, glm::vec3 b, glm::vec3 c, float away, std::vector<float>& cells) {
  const float longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
  if (longest > 0.75f * layout.cell) {
    const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
    add_skin(layout, a, ab, ca, away / 4, cells), add_skin(layout, ab, b, bc, away / 4, cells);
    add_skin(layout, ca, bc, c, away / 4, cells), add_skin(layout, ab, bc, ca, away / 4, cells);
    return;
  }
  const glm::ivec3 cell(glm::floor(((a + b + c) / 3.0f - layout.low) / layout.cell));
  if (layout.has(cell)) cells[layout.index(cell)] += away / (layout.cell * layout.cell);
}

/// Returns how much of each cell's face the skin covers. Only skin that faces away from the light stops it, so that
/// nothing lies in its own shadow, whatever the size of the cells.
std::vector<float> skin_facing_away(const GridLayout& layout, const FurModel& model, const FurLight& light) {
  std::vector<float> cells(layout.count());
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::vec3 a = model.positions[t.x], b = model.positions[t.y], c = model.positions[t.z];
    const glm::vec3 apart = (a + b + c) / 3.0f - light.position;
    const glm::vec3 from =
        light.kind == LightKind::directional ? light.direction : apart / std::max(glm::length(apart), 1e-6f);
    const float away = 0.5f * glm::dot(glm::cross(b - a, c - a), from) * model.corners[i][0].weight;
    if (away > 0) add_skin(layout, a, b, c, away, cells);
  }
  return cells;
}

std::uint16_t rounded(float sum, std::uint16_t max) {
  return static_cast<std::uint16_t>(std::min(sum + 0.5f, static_cast<float>(max)));
}

/// A sum of cells before rounding, in steps of 1 / Crossed::one.
struct Sum {
  float strands = 0, body = 0;

  void add(const Crossed& cell, float share) {
    strands += share * static_cast<float>(cell.strands), body += share * static_cast<float>(cell.body);
  }
  Crossed rounded_sum() const { return {rounded(strands, Crossed::max_strands), rounded(body, Crossed::max_body)}; }
};

/// Returns the cells along an axis in the order in which light reaches them: from its position to both ends.
std::vector<int> order_from(float light, int size) {
  const float clamped = std::clamp(light, 0.0f, static_cast<float>(size) - 1);
  const int first = static_cast<int>(clamped);
  std::vector<int> order;
  for (int i = first; i < size; ++i) order.push_back(i);
  for (int i = first - 1; i >= 0; --i) order.push_back(i);
  return order;
}

/// Weighted sums for a range of cells of one row.
class RowSums {
 public:
  explicit RowSums(const GridLayout& layout) : layout_(layout), sums_(2 * static_cast<std::size_t>(layout.size.x)) {}

  void begin(int y, int z, CellRange cells) {
    y_ = y, z_ = z, cells_ = cells;
    std::fill(sums_.begin() + 2 * cells.begin, sums_.begin() + 2 * cells.end, 0.0f);
  }
  void add(const std::vector<Crossed>& from, const CellTap& tap) {
    const int y = y_ + tap.off.y, z = z_ + tap.off.z;
    if (tap.share == 0 || !layout_.has({0, y, z})) return;
    const int begin = std::max(cells_.begin, -tap.off.x), end = std::min(cells_.end, layout_.size.x - tap.off.x);
    if (begin >= end) return;
    add_cells(std::span(from).subspan(layout_.index({begin + tap.off.x, y, z}), static_cast<std::size_t>(end - begin)),
              tap.share, &sums_[2 * static_cast<std::size_t>(begin)]);
  }
  /// Stores the rounded sums. Returns the range of cells that changed.
  CellRange round_into(std::vector<Crossed>& to, bool quantize) const {
    const auto count = static_cast<std::size_t>(cells_.end - cells_.begin);
    CellRange changed = round_cells(&sums_[2 * static_cast<std::size_t>(cells_.begin)], quantize,
                                    std::span(to).subspan(layout_.index({cells_.begin, y_, z_}), count));
    return {changed.begin + cells_.begin, changed.end + cells_.begin};
  }
  /// The same, where each cell also adds the new value of its neighbour in the row, which is stored just before it.
  CellRange round_in_order(const CellTap& beside, std::vector<Crossed>& to) const {
    CellRange changed;
    const int step = -beside.off.x;
    const std::size_t first = layout_.index({0, y_, z_});
    for (int x = step > 0 ? cells_.begin : cells_.end - 1; x >= cells_.begin && x < cells_.end; x += step) {
      Sum sum{sums_[2 * static_cast<std::size_t>(x)], sums_[2 * static_cast<std::size_t>(x) + 1]};
      const int before = x + beside.off.x;
      if (before >= 0 && before < layout_.size.x) sum.add(to[first + static_cast<std::size_t>(before)], beside.share);
      Crossed& cell = to[first + static_cast<std::size_t>(x)];
      const Crossed now = sum.rounded_sum();
      if (!(cell == now)) changed.add({x, x + 1}), cell = now;
    }
    return changed;
  }

 private:
  const GridLayout& layout_;
  std::vector<float> sums_;  // strands and body of each cell of the row
  int y_ = 0, z_ = 0;
  CellRange cells_;
};

}  // namespace

/// The cells that a ray from a cell to the light passes, relative to the cell, with their weights.
struct LightCells::RayTaps {
  std::array<CellTap, 4> before;               // neighbours on the light's side, between which the ray passes
  float longer = 1;                            // length of the ray between two slices across its main axis, cells
  std::array<CellTap, light_near_steps> near;  // cells along the ray, one for each step of a cell
  std::array<CellTap, 8> beyond;               // cells around the end of those steps, to interpolate between

  /// `steps`: for each axis 1, or 0 if the light lies in the cell's own slice along it: then no light comes from the
  /// next slice.
  explicit RayTaps(glm::vec3 to_light, glm::vec3 steps = glm::vec3(1)) {
    const glm::vec3 size = glm::abs(to_light);
    const int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const glm::ivec3 step(glm::sign(to_light));
    longer = 1 / std::max(size[a], 0.5f);
    const float off_b = size[b] * longer * steps[b], off_c = size[c] * longer * steps[c];
    for (std::size_t k = 0; k < before.size(); ++k) {
      glm::ivec3 off(0);
      off[a] = step[a];
      if (k & 1) off[b] = step[b];
      if (k & 2) off[c] = step[c];
      const float share = (k & 1 ? off_b : 1 - off_b) * (k & 2 ? off_c : 1 - off_c);
      before[k] = {off, off == glm::ivec3(0) ? 0.0f : share * steps[a]};
    }
    for (int s = 1; s < light_near_steps; ++s)
      near[static_cast<std::size_t>(s)] = {glm::ivec3(glm::floor(0.5f + to_light * static_cast<float>(s))), 1};
    near[0] = {{}, 0.5f};
    const glm::vec3 end = to_light * static_cast<float>(light_near_steps), low = glm::floor(end), part = end - low;
    for (int k = 0; k < 8; ++k) {
      const glm::ivec3 off(k & 1, k >> 1 & 1, k >> 2);
      const glm::vec3 share = glm::mix(1.0f - part, part, glm::vec3(off));
      beyond[static_cast<std::size_t>(k)] = {glm::ivec3(low) + off, share.x * share.y * share.z};
    }
  }
};

LightCells::LightCells(const GridLayout& layout, std::span<const CellDensity> density, const FurModel& model,
                       const FurLight& light)
    : layout_(layout),
      light_(light),
      directional_(light.kind == LightKind::directional),
      source_(directional_ ? -light.direction : (light.position - layout.low) / layout.cell),
      local_(layout.count()),
      through_(layout.count()),
      crossed_(layout.count()) {
  const std::vector<float> skin = skin_facing_away(layout, model, light);
  for (std::size_t i = 0; i < skin.size(); ++i)
    local_[i].body = rounded(Crossed::one * skin_depth * skin[i], Crossed::max_body);
  CellRows all(layout.rows(), {0, layout.size.x});
  follow(density, all, all);
}

glm::vec3 LightCells::to_light(glm::vec3 cell) const {
  if (directional_) return source_;
  const glm::vec3 apart = source_ - cell;
  return apart / std::max(glm::length(apart), 1e-3f);
}

std::vector<std::uint32_t> LightCells::update(std::span<const CellDensity> density, const CellRows& changed) {
  CellRows local(layout_.rows());
  return follow(density, changed, local);
}

/// `local`: cells that count as changed in any case.
std::vector<std::uint32_t> LightCells::follow(std::span<const CellDensity> density, const CellRows& changed,
                                              CellRows& local) {
  for (int z = 0; z < layout_.size.z; ++z)
    for (int y = 0; y < layout_.size.y; ++y) {
      const std::size_t row = layout_.row(y, z);
      local[row].add(find_local(density, y, z, changed[row]));
    }
  if (!directional_) return follow_near();
  const RayTaps direction(source_);
  return look_back(direction, local, sweep(direction, local));
}

/// Finds how many strands a light ray crosses within each cell, over a path as long as the cell is wide. Returns the
/// cells where that has changed.
CellRange LightCells::find_local(std::span<const CellDensity> density, int y, int z, CellRange cells) {
  CellRange changed;
  for (int x = cells.begin; x < cells.end; ++x) {
    const std::size_t at = layout_.index({x, y, z});
    const CellDensity& fur = density[at];
    std::uint16_t strands = 0;
    if (fur.sum[0] > 0) {
      const glm::vec3 direction(fur.sum[1], fur.sum[2], fur.sum[3]);
      const float total = static_cast<float>(fur.sum[0]);
      const float along = glm::dot(direction, to_light(glm::vec3(x, y, z) + 0.5f)) / total;
      const float across = std::sqrt(std::max(1 - (1 - strand_spread) * along * along, 0.0f));
      strands = rounded(Crossed::one / CellDensity::one * total * across, Crossed::max_strands);
    }
    if (local_[at].strands == strands) continue;
    local_[at].strands = strands;
    changed.add({x, x + 1});
  }
  return changed;
}

/// Marks the cells that read a changed cell through a tap.
void LightCells::add_readers(const CellRows& changed, const CellTap& tap, CellRows& readers) const {
  if (tap.share == 0) return;
  for (int z = std::max(0, -tap.off.z); z < std::min(layout_.size.z, layout_.size.z - tap.off.z); ++z)
    for (int y = std::max(0, -tap.off.y); y < std::min(layout_.size.y, layout_.size.y - tap.off.y); ++y)
      readers[layout_.row(y, z)].add(
          tap.readers_of(changed[layout_.row(y + tap.off.y, z + tap.off.z)], layout_.size.x));
}

/// Finds what the light crosses up to each cell's far side, by short characteristics (Kunasz and Auer 1988): a cell
/// adds its own crossing to that of the four neighbours on the light's side. The interpolation spreads light a little
/// from cell to cell, so that distant shadows have soft edges. Returns the cells that changed.
CellRows LightCells::sweep(const RayTaps& direction, const CellRows& local) {
  const glm::vec3 start = glm::sign(source_) * 1e9f;
  CellRows through(layout_.rows());
  RowSums sums(layout_);
  const CellTap* beside = nullptr;  // the neighbour in the row itself, if any
  for (const CellTap& tap : direction.before)
    if (tap.off.y == 0 && tap.off.z == 0 && tap.share > 0) beside = &tap;
  for (const int z : order_from(start.z, layout_.size.z)) {
    for (const int y : order_from(start.y, layout_.size.y)) {
      CellRange cells = local[layout_.row(y, z)];
      for (const CellTap& tap : direction.before)
        if (const glm::ivec3 at = glm::ivec3(0, y, z) + glm::ivec3(0, tap.off.y, tap.off.z); layout_.has(at))
          cells.add(tap.readers_of(through[layout_.row(at.y, at.z)], layout_.size.x));
      if (cells.empty()) continue;
      if (beside) (beside->off.x > 0 ? cells.begin : cells.end) = beside->off.x > 0 ? 0 : layout_.size.x;
      sums.begin(y, z, cells);
      sums.add(local_, {{}, direction.longer});
      for (const CellTap& tap : direction.before)
        if (&tap != beside) sums.add(through_, tap);
      through[layout_.row(y, z)] = beside ? sums.round_in_order(*beside, through_) : sums.round_into(through_, false);
    }
  }
  return through;
}

/// Finds what the light crosses up to each cell's middle: sums the cells along the ray itself near the cell, so that
/// shadows of near fur are sharp, and adds through_ from there on. Returns the cells that changed.
std::vector<std::uint32_t> LightCells::look_back(const RayTaps& direction, const CellRows& local,
                                                 const CellRows& through) {
  CellRows readers(layout_.rows());
  std::vector<std::uint32_t> changed;
  std::vector<Crossed> before;
  for (const CellTap& tap : direction.near) add_readers(local, tap, readers);
  for (const CellTap& tap : direction.beyond) add_readers(through, tap, readers);
  RowSums sums(layout_);
  for (int z = 0; z < layout_.size.z; ++z) {
    for (int y = 0; y < layout_.size.y; ++y) {
      const CellRange cells = readers[layout_.row(y, z)];
      if (cells.empty()) continue;
      sums.begin(y, z, cells);
      for (const CellTap& tap : direction.near) sums.add(local_, tap);
      for (const CellTap& tap : direction.beyond) sums.add(through_, tap);
      const std::size_t first = layout_.index({0, y, z});
      const auto row = crossed_.begin() + static_cast<std::ptrdiff_t>(first);
      before.assign(row + cells.begin, row + cells.end);
      sums.round_into(crossed_, true);
      for (int x = cells.begin; x < cells.end; ++x)
        if (!(before[static_cast<std::size_t>(x - cells.begin)] == row[x]))
          changed.push_back(static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(x));
    }
  }
  return changed;
}

/// Updates a light that has a position. The direction to it differs from cell to cell, so that this sweeps all cells,
/// in the order in which light reaches them. Returns the cells that changed.
std::vector<std::uint32_t> LightCells::follow_near() {
  const auto add = [&](const auto& taps, glm::ivec3 cell, const std::vector<Crossed>& from, Sum& sum) {
    for (const CellTap& tap : taps)
      if (layout_.has(cell + tap.off)) sum.add(from[layout_.index(cell + tap.off)], tap.share);
  };
  const std::vector<int> along = order_from(source_.x, layout_.size.x), down = order_from(source_.y, layout_.size.y);
  const glm::ivec3 first(glm::clamp(source_, glm::vec3(0), glm::vec3(layout_.size - 1)));
  for (const int z : order_from(source_.z, layout_.size.z)) {
    for (const int y : down) {
      for (const int x : along) {
        const glm::ivec3 cell(x, y, z);
        const RayTaps direction(to_light(glm::vec3(cell) + 0.5f), glm::notEqual(cell, first));
        Sum sum;
        sum.add(local_[layout_.index(cell)], direction.longer);
        add(direction.before, cell, through_, sum);
        through_[layout_.index(cell)] = sum.rounded_sum();
      }
    }
  }
  std::vector<std::uint32_t> changed;
  for (std::size_t at = 0; at < crossed_.size(); ++at) {
    const glm::ivec3 cell = layout_.cell_of(at);
    const RayTaps direction(to_light(glm::vec3(cell) + 0.5f));
    Sum sum;
    add(direction.near, cell, local_, sum), add(direction.beyond, cell, through_, sum);
    const std::array<float, 2> sums{sum.strands, sum.body};
    if (!round_cells(sums.data(), true, std::span(crossed_).subspan(at, 1)).empty())
      changed.push_back(static_cast<std::uint32_t>(at));
  }
  return changed;
}

}  // namespace pelage
