// Strands in small cells where the camera is near: what of single strands lies in the way of light, as contact shadows.
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

/// The parts that a picture shows from near: their single strands are looked for.
std::vector<std::uint32_t> near_parts(const RasterScene& scene);
/// A side of a near cell, where the density grid has cells of that side.
float near_cell_side(float cell);

/// Cells by a hash of their coordinates (Teschner et al. 2003): most of the space around fur is empty.
class NearCells {
 public:
  static constexpr std::uint32_t count = near_places;  // for cells; a few share one
  static constexpr float one = near_one;

  /// Holds the strands of all parts that the picture shows from near. `version` is that of the density grid.
  /// Deterministic for any number of threads.
  void update(const RasterScene& scene, std::uint64_t version, int threads);

  /// Sizes.
  float cell() const { return cell_; }
  /// What strands cover of each cell's face, whichever way they lie, in steps of 1 / one; none where nothing is near.
  std::span<const std::uint16_t> cells() const { return cells_; }
  /// The mean over all cells: so much of other cells lies in each.
  float mean() const { return mean_; }
  /// The version of the density grid at which the near cells last changed. Such a change may alter the look of every
  /// place, because places share cells and the mean changes too.
  std::uint64_t since() const { return since_; }
  std::size_t bytes() const { return cells_.capacity() * sizeof(std::uint16_t); }

 private:
  void fill(int threads);

  float cell_ = 1, mean_ = 0;
  std::vector<std::uint16_t> cells_;
  std::vector<std::uint32_t> parts_;                    // that are near
  std::vector<std::shared_ptr<const StrandSet>> held_;  // of each of them
  std::uint64_t since_ = 0;
};

}  // namespace pelage
