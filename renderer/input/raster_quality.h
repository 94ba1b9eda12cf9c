// The density and the lighting rate of rasterized strands.
#pragma once

#include <algorithm>
#include <cmath>

#include "protocol/commands/frame.h"

namespace pelage {

struct RasterQuality {
  double strands_a_pixel = 1;  // strands to draw for each pixel of skin seen from above, above 0
  int lit_of = 1;              // one strand of this many is lit, and the others share its light, [1, 8]

  /// Returns the width in pixels up to which strands are widened to replace those that are left out; to stay below it
  /// more strands are drawn. Wider ones would look like wires, which is acceptable only in drafts.
  double widest() const { return std::clamp(1 / strands_a_pixel, 1.5, 2.0); }

  /// Returns the share of strands to draw, (0, 1], for `on_a_pixel` strands on a pixel and a strand `width` in pixels.
  double drawn_strand_share(double on_a_pixel, double width) const {
    return std::min(std::max(strands_a_pixel / std::max(on_a_pixel, 1e-12), width / widest()), 1.0);
  }
};

/// `winding`: length along a strand over its straight length, at least 1. A curled strand covers that many times as
/// much. The number of strands is divided by its square root: halfway between the number for straight fur and the
/// number with the same coverage.
inline RasterQuality quality_of(const Knobs& knobs, double winding) {
  return {knobs.raster.strands / std::sqrt(winding), knobs.raster.light_of};
}

}  // namespace pelage
