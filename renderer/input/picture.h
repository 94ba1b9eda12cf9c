// Pixels of a picture, for all who draw.
#pragma once

namespace pelage {

/// Half-open, from the left and the top, pixels.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Nothing nearer is drawn, sizes along the view; as the camera of renderer/upload/blocks.cpp.
inline constexpr float near_distance = 1e-4f;

}  // namespace pelage
