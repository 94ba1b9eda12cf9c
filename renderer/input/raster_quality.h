// Which strands are drawn, and how closely.
#pragma once

#include <algorithm>
#include <cmath>

#include "protocol/commands/frame.h"

namespace pelage {

struct RasterQuality {
  double strands_a_pixel = 1;  // that are kept of those that stand on a pixel of skin seen from above, above 0
  int lit_of = 1;              // strands share the light of one of so many, [1, 8]

  /// Pixels that strands are widened to for those that are left out: beyond it more are kept. Wider ones look like
  /// wires, which passes in a draft alone.
  double widest() const { return std::clamp(1 / strands_a_pixel, 1.5, 2.0); }

  /// Of the strands, where so many stand on a pixel and are so many pixels wide: (0, 1].
  double kept_share(double on_a_pixel, double width) const {
    return std::min(std::max(strands_a_pixel / std::max(on_a_pixel, 1e-12), width / widest()), 1.0);
  }
};

/// `winding`: the way along a strand over its length, 1 or more. A curled one covers so many times as much: by its
/// root, halfway between as many strands as straight fur has and as many as cover what those do.
inline RasterQuality quality_of(const Knobs& knobs, double winding) {
  return {knobs.raster.strands / std::sqrt(winding), knobs.raster.light_of};
}

}  // namespace pelage
