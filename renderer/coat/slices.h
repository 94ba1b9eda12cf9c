// The slices baked from the strands of a tile, one for each of `slice_count` heights, with mip levels that preserve the
// transmittance of the whole stack (science.md 1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "protocol/commands/coat.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// One mip level: `texels * texels * slice_count` texels of 4 bytes, x fastest, then y, then the slice.
///   shape: slope of the strand (x, y; unnormalised mean, .5 is upright); exp(-n / stored_light), where n strands lie
///   between the texel and light that comes at 45 degrees; optical depth (linear).
///   colour: colour of the strand (square root of linear, which keeps steps in dark colours), and its number.
struct SliceLevel {
  int texels = 0;
  std::vector<std::uint8_t> shape;
  std::vector<std::uint8_t> colour;
  /// Factors on the stored optical depth, for rays along the stack and at 60, 30 and 75 degrees to it. They make the
  /// transmittance match that of opaque strands: of each slice at 60 degrees, of the whole stack along it, and averaged
  /// over the slices at 30 and 75 degrees.
  std::array<double, 4> depth_scale{1, 1, 1, 1};
};

struct Slices {
  std::vector<SliceLevel> levels;  // slice_levels
  /// Mean number of strands above each slice's middle that a ray at 45 degrees crosses, in fur nominal_length long.
  std::array<float, slice_count> depth_above{};
};

/// Bakes the slices of a coat; deterministic. Takes a fraction of a second for 10,000 strands. `go_on` is called on
/// several threads for each slice; once it has returned false, baking stops and returns no levels, whatever it returns
/// later.
Slices bake_slices(const Coat& coat, const std::function<bool()>& go_on = {});

/// Returns the slices without their texels, for a caller that stores those elsewhere: scales and depths.
Slices without_texels(const Slices& slices);

/// Return the bytes of the slices, and the peak bytes of baking with the slices included.
std::size_t slices_bytes();
std::size_t baking_bytes();

/// Provides a renderer with the slices of a coat.
using CoatSource = std::function<std::shared_ptr<const Slices>(const Coat& coat)>;

/// Bakes the slices on the caller's thread.
std::shared_ptr<const Slices> bake_here(const Coat& coat);

// The colour of the fur that light crosses on its way to a strand. Self-shadow takes its colour from there, not from
// the strand that it falls on; otherwise dark roots under pale tips would turn black.

/// Returns for the middle of each slice, by channel, the ramp's mean from there to the tip over the ramp's colour
/// there. It is 1 on a ramp of one colour and in [0, 100] on any; black stays black.
std::array<glm::vec3, slice_count> colour_above(const Coat& coat);

}  // namespace pelage
