// Ray tests against a coat's opaque strands: the reference that baked slices have to match.
#pragma once

#include <array>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

/// Returns for each slice the share of rays from above that get past it, in [0, 1], decreasing from the last slice to
/// the first. The fur is upright and nominal_length long; `tangent` is that of the rays' angle to the normal.
std::array<double, slice_count> ray_transmittance(const Coat& coat, const std::vector<Strand>& strands, double tangent);

inline constexpr int crossing_cells = 64;  // cells along a side of the tile

/// For each slice and cell (x fastest), the number of strands that a ray at 45 degrees crosses there, in fur
/// nominal_length long: the sum of diameter times height over the cell's area.
using CrossingGrid = std::array<std::vector<double>, slice_count>;
CrossingGrid crossings_of(const Coat& coat, const std::vector<Strand>& strands);

}  // namespace pelage
