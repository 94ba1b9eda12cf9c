// How rays hit a coat's opaque strands: the reference that baked slices have to match.
#pragma once

#include <array>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

/// For each slice the share of rays from above that get past it, in [0, 1], falling from the last slice to the first.
/// The fur stands upright and is nominal_length long; rays have an angle with that `tangent` to the normal.
std::array<double, slice_count> rays_let_through(const Coat& coat, const std::vector<Strand>& strands, double tangent);

inline constexpr int crossing_cells = 64;  // on a side of the tile

/// For each slice and cell (x fastest), how many strands a ray crosses there that goes as far sideways as it rises, in
/// fur nominal_length long: the sum of diameter times height over the cell's area.
using CrossingGrid = std::array<std::vector<double>, slice_count>;
CrossingGrid crossings_of(const Coat& coat, const std::vector<Strand>& strands);

}  // namespace pelage
