// The slices baked from the strands of a tile, one for each of `slice_count` heights, with mip levels that keep what
// the whole stack lets through (science.md 1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

inline constexpr int slice_count = 32;        // N0: layers that the depth was baked as
inline constexpr int slice_texels = 512;      // a side of the finest level
inline constexpr int slice_levels = 8;        // 512 ... 4
inline constexpr double stored_depth = 6;     // optical depth (natural log) of a stored 255
inline constexpr double stored_slope = 0.06;  // sideways per height, in sizes, of a stored +-1

/// One level: `texels * texels * slice_count` texels of 4 octets, x fastest, then y, then the slice.
///  shape: the strand's slope (x, y; unnormalised mean, .5 is upright), light from above, optical depth (linear).
///  colour: the strand's colour (sqrt of linear, so that dark ones keep their steps), and its number.
struct SliceLevel {
  int texels = 0;
  std::vector<std::uint8_t> shape;
  std::vector<std::uint8_t> colour;
  /// Factors on the optical depth for a view along the strands' stack and at 60 degrees to it, for which the stack's
  /// mean transmittance is that of the finest level.
  std::array<double, 2> depth_scale{1, 1};
};

struct Slices {
  std::vector<SliceLevel> levels;
  /// Mean optical depth above each slice's middle for light along the normal, slant and multiple scattering included.
  std::array<float, slice_count> depth_above{};
};

/// Deterministic in the coat alone. A fraction of a second for 10,000 strands.
Slices bake_slices(const Coat& coat);

}  // namespace pelage
