// How much fur stands in each cell of a grid around a model, and how much of it and of the body each light goes
// through on its way there: the shadows that fur and body cast on fur.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/light_cells.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Two lights, so that a cell's numbers lie side by side; one that is not there crosses nothing.
using CrossedByTwo = std::array<Crossed, 2>;

class DensityGrid {
 public:
  /// Brings the grid up to date: fur where parts have changed, light where fur or lights have. Curves cast no shadow:
  /// they are too thin for cells. Deterministic for any number of threads.
  void update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights, int threads);

  const GridPlace& place() const { return place_; }
  /// Of each cell, without curves.
  std::span<const CellDensity> density() const { return density_; }
  /// How often the fur in it was another so far.
  std::uint64_t changes() const { return changes_; }
  /// Of each cell, of lights 2 pair and 2 pair + 1.
  const std::vector<CrossedByTwo>& crossed(std::size_t pair) const { return crossed_[pair]; }
  std::size_t bytes() const;

 private:
  /// Whether anything has changed.
  bool add_fur(std::span<const GrownPart> parts, int threads);

  GridPlace place_;
  std::vector<CellDensity> density_;
  std::vector<GrownPart> held_;  // what is in it of each part; no strands for nothing
  std::uint64_t model_ = 0, changes_ = 0;
  std::vector<FurLight> lights_;  // that have been followed
  std::vector<std::vector<CrossedByTwo>> crossed_;
};

}  // namespace pelage
