// Density of single strands in small cells near the camera, for the contact shadows between strands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/shaders/constants.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

struct RasterScene;

/// Returns the parts that the picture shows from near, which cast contact shadows strand by strand.
std::vector<std::uint32_t> near_parts(const RasterScene& scene);
/// Returns the side of a near cell for a density grid with cells of side `cell`.
float near_cell_side(float cell);

/// Cells found by a hash of their coordinates (Teschner et al. 2003), because most of the space around fur is empty.
class NearCells {
 public:
  static constexpr std::uint32_t count = near_entries;  // entries of the hash table; some cells share one
  static constexpr float one = near_one;

  /// Updates the cells to the strands of near_parts. `version` is that of the density grid.
  /// Deterministic for any number of threads.
  void update(const RasterScene& scene, std::uint64_t version, int threads);

  /// Returns the side of a cell, sizes.
  float cell() const { return cell_; }
  /// Returns how much of each cell's face strands cover, whatever their direction, in steps of 1 / one; empty if no
  /// part is near.
  std::span<const std::uint16_t> cells() const { return cells_; }
  /// Returns the mean over all entries: what an entry has of other cells, on average.
  float mean() const { return mean_; }
  /// Returns the version of the density grid at which the near cells last changed. Such a change may alter the picture
  /// anywhere, because cells share entries and the mean changes too.
  std::uint64_t since() const { return since_; }
  std::size_t bytes() const { return cells_.capacity() * sizeof(std::uint16_t); }

 private:
  void fill(int threads);

  float cell_ = 1, mean_ = 0;
  std::vector<std::uint16_t> cells_;
  std::vector<std::uint32_t> parts_;                       // near_parts that are in the cells
  std::vector<std::shared_ptr<const StrandSet>> strands_;  // strands of each of parts_
  std::uint64_t since_ = 0;
};

}  // namespace pelage
