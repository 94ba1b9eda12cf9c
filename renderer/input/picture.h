// Pixels of a picture, for all who draw.
#pragma once

namespace pelage {

/// Half-open, from the left and the top, pixels.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

}  // namespace pelage
