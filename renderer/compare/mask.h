// Where fur is in a picture, and the band around its outline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

/// One byte for each pixel, rows from the top: 1 inside, 0 outside.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> inside;

  std::size_t count() const;
};

/// Where alpha is at least 1/255: what eight bits can show. NaN is outside.
Mask alpha_mask(const FloatImage& image);

/// Where the picture is brighter than half, times alpha: for masks drawn as pictures.
Mask luminance_mask(const FloatImage& image);

/// Inside either of two masks of one size.
Mask union_of(const Mask& first, const Mask& second);

/// Pixels whose centre lies at most `pixels` from that of a pixel on the other side of the mask's edge. The picture's
/// border is no edge. `pixels` in [0, 1000].
Mask outline_band(const Mask& mask, double pixels);

}  // namespace pelage
