// A box of pixels, for all drawing code.
#pragma once

namespace pelage {

/// A half-open box in pixels, from the left and the top.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

}  // namespace pelage
