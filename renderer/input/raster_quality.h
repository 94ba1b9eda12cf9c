// Which strands are drawn, and how closely.
#pragma once

#include <algorithm>

namespace pelage {

struct RasterQuality {
  double strands_a_pixel = 1;  // that are kept of those that stand on a pixel of skin seen from above, above 0
  int lit_of = 1;              // strands share the light of one of so many, [1, 8]

  /// Pixels that strands are widened to for those that are left out: beyond it more are kept. Wider ones look like
  /// wires, which passes in a draft alone.
  double widest() const { return std::clamp(1 / strands_a_pixel, 1.5, 2.0); }
};

}  // namespace pelage
