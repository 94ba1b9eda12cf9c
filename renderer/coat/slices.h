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

/// One level: `texels * texels * slice_count` texels of 4 bytes, x fastest, then y, then the slice.
///  shape: the strand's slope (x, y; unnormalised mean, .5 is upright), exp(-n / stored_light) where n strands lie
///  between the texel and light that comes at 45 degrees, optical depth (linear).
///  colour: the strand's colour (sqrt of linear, so that dark ones keep their steps), and its number.
struct SliceLevel {
  int texels = 0;
  std::vector<std::uint8_t> shape;
  std::vector<std::uint8_t> colour;
  /// Factors on the stored optical depth, along the strands' stack and at 60, 30 and 75 degrees to it. With them as
  /// many rays as with opaque strands get past each slice at 60 degrees, and past all slices along the stack; at 30 and
  /// 75 degrees rays reach as deep on average.
  std::array<double, 4> depth_scale{1, 1, 1, 1};
};

struct Slices {
  std::vector<SliceLevel> levels;  // slice_levels
  /// Strands above each slice's middle that a ray at 45 degrees crosses on average, in fur nominal_length long.
  std::array<float, slice_count> depth_above{};
};

/// Deterministic in the coat alone. A fraction of a second for 10,000 strands. `go_on` is asked on several threads for
/// each slice; once it has answered false the work ends, without levels, whatever it answers later.
Slices bake_slices(const Coat& coat, const std::function<bool()>& go_on = {});

/// Returns the slices without their texels, for a caller that stores those elsewhere: scales and depths.
Slices without_texels(const Slices& slices);

/// Bytes of the slices; and the most that baking takes at a time, with them.
std::size_t slices_bytes();
std::size_t baking_bytes();

/// Gives a renderer the slices of coats.
using CoatSource = std::function<std::shared_ptr<const Slices>(const Coat& coat)>;

/// Bakes them on the caller's thread.
std::shared_ptr<const Slices> bake_here(const Coat& coat);

// The colour of the fur that light crosses on its way to a strand: self-shadow takes its colour from there, not from
// the strand that it falls on, or dark roots under pale tips turn black.

/// For the middle of each slice, by channel: the ramp's mean from there to the tip over the ramp's colour there. 1 on a
/// ramp of one colour, in [0, 100] on any; what is black there stays black.
std::array<glm::vec3, slice_count> colour_above(const Coat& coat);

}  // namespace pelage
