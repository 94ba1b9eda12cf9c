// Traces one light through the cells of a grid: how much fur and body it crosses on its way to each cell.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// Layout of the cells: cell c is the cube with its centre at low + (c + .5) cell.
struct GridLayout {
  glm::vec3 low{0};
  float cell = 1;      // sizes
  glm::ivec3 size{2};  // cells along each axis, at least 2

  std::size_t rows() const { return static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z); }
  std::size_t count() const { return static_cast<std::size_t>(size.x) * rows(); }
  std::size_t row(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(y);
  }
  std::size_t index(glm::ivec3 c) const {
    return row(c.y, c.z) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(c.x);
  }
  glm::ivec3 cell_of(std::size_t index) const {
    const auto across = static_cast<std::size_t>(size.x), down = static_cast<std::size_t>(size.y);
    return {index % across, index / across % down, index / (across * down)};
  }
  bool has(glm::ivec3 c) const {
    return !glm::any(glm::lessThan(c, glm::ivec3(0))) && !glm::any(glm::greaterThanEqual(c, size));
  }
  bool operator==(const GridLayout&) const = default;
};

/// A range of cells in a row along x, half-open.
struct CellRange {
  int begin = 0, end = 0;

  bool empty() const { return begin >= end; }
  void add(CellRange other) {
    if (other.empty()) return;
    *this = empty() ? other : CellRange{std::min(begin, other.begin), std::max(end, other.end)};
  }
};
/// A range for each row of a grid.
using CellRows = std::vector<CellRange>;

/// A cell that another cell reads: its offset from that cell, and the weight of its value.
struct CellTap {
  glm::ivec3 off{0};
  float share = 0;

  /// Returns the cells of a row that read a changed cell, if `changed` lies in the row at this offset.
  CellRange readers_of(CellRange changed, int size) const {
    if (changed.empty() || share == 0) return {};
    return {std::max(changed.begin - off.x, 0), std::min(changed.end - off.x, size)};
  }
};

/// How much of a cell's face its strands cover, and that times their direction (x, y, z), in fixed point, so that the
/// sums do not depend on the order in which strands are added.
struct CellDensity {
  static constexpr float one = density_one;
  std::array<std::int64_t, 4> sum{};
};

/// What a light crosses on its way to a cell, in fixed point. Rounding removes the effect of distant changes, so that a
/// change only affects cells near it.
struct Crossed {
  static constexpr float one = crossed_one;
  static constexpr std::uint16_t max_strands = max_crossed_strands, max_body = max_crossed_body;
  std::uint16_t strands = 0;  // mean number of strands that the light crosses
  std::uint16_t body = 0;     // optical depth of the skin

  bool operator==(const Crossed&) const = default;
};
static_assert(sizeof(Crossed) == 4);

/// What one light crosses on its way to each cell. The bits are the same whether the cells were computed at once or
/// updated change by change.
class LightCells {
 public:
  LightCells(const GridLayout& layout, std::span<const CellDensity> density, const FurModel& model,
             const FurLight& light);

  /// Updates the cells after the density has changed in the cells of `changed`. Returns the indices of the cells whose
  /// values changed.
  std::vector<std::uint32_t> update(std::span<const CellDensity> density, const CellRows& changed);

  const FurLight& light() const { return light_; }
  std::span<const Crossed> crossed() const { return crossed_; }
  std::size_t bytes() const { return 3 * crossed_.size() * sizeof(Crossed); }

 private:
  struct RayTaps;
  glm::vec3 to_light(glm::vec3 cell) const;
  std::vector<std::uint32_t> follow(std::span<const CellDensity> density, const CellRows& changed, CellRows& local);
  CellRange find_local(std::span<const CellDensity> density, int y, int z, CellRange cells);
  void add_readers(const CellRows& changed, const CellTap& tap, CellRows& readers) const;
  CellRows sweep(const RayTaps& direction, const CellRows& local);
  std::vector<std::uint32_t> look_back(const RayTaps& direction, const CellRows& local, const CellRows& through);
  std::vector<std::uint32_t> follow_near();

  GridLayout layout_;
  FurLight light_;
  bool directional_;  // the light is directional
  glm::vec3 source_;  // position of the light, in cells; for a directional light, the direction to it
  // For each cell: what the light crosses within it, up to its far side, and up to its middle.
  std::vector<Crossed> local_, through_, crossed_;
};

}  // namespace pelage
