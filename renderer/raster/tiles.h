// The square tiles of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/input/picture.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// The number of tiles in each direction of a box; tiles are numbered row by row.
struct TileRows {
  int across = 0, down = 0;
  int count() const { return across * down; }
};
inline TileRows tiles_of(const PixelBox& box) {
  return {(box.right - box.left + tile_side - 1) / tile_side, (box.bottom - box.top + tile_side - 1) / tile_side};
}

/// A set of tiles of a picture; tiles start at its upper left corner.
class TileMask {
 public:
  TileMask(int width, int height);

  /// Adds all tiles that a box touches.
  void add(const PixelBox& box);
  void add(float left, float top, float right, float bottom);
  void add(const TileMask& other);
  bool has(int left, int top) const { return on_[at(left / tile_side, top / tile_side)] != 0; }
  /// Returns whether a box of pixels touches any tile of the set.
  bool touches(float left, float top, float right, float bottom) const;
  /// Returns the box around all tiles of the set, clipped to the picture; empty if the set is.
  PixelBox bounds() const;
  int count() const;

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles_.across) + static_cast<std::size_t>(x);
  }
  /// Returns the tiles that a box of pixels touches: a half-open range of columns and rows.
  PixelBox tiles_in(float left, float top, float right, float bottom) const;

  int width_, height_;
  TileRows tiles_;
  std::vector<std::uint8_t> on_;
};

}  // namespace pelage
