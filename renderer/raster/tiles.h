// A picture in square tiles.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/input/picture.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// Tiles of a box, row by row.
struct TileRows {
  int across = 0, down = 0;
  int count() const { return across * down; }
};
inline TileRows tiles_of(const PixelBox& box) {
  return {(box.right - box.left + tile_side - 1) / tile_side, (box.bottom - box.top + tile_side - 1) / tile_side};
}

/// Some tiles of a picture, from its left upper corner on.
class TileMask {
 public:
  TileMask(int width, int height);

  /// All that a box touches.
  void add(const PixelBox& box);
  void add(float left, float top, float right, float bottom);
  void add(const TileMask& other);
  bool has(int left, int top) const { return on_[at(left / tile_side, top / tile_side)] != 0; }
  /// Returns whether a box of pixels touches any of them.
  bool touches(float left, float top, float right, float bottom) const;
  /// Around all of them, within the picture; no pixels where there are none.
  PixelBox bounds() const;
  int count() const;

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles_.across) + static_cast<std::size_t>(x);
  }
  /// Tiles, half-open.
  PixelBox tiles_in(float left, float top, float right, float bottom) const;

  int width_, height_;
  TileRows tiles_;
  std::vector<std::uint8_t> on_;
};

}  // namespace pelage
