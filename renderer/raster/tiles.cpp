#include "renderer/raster/tiles.h"

#include <algorithm>

#include "base/clamped_index.h"

namespace pelage {

TileMask::TileMask(int width, int height)
    : width_(width),
      height_(height),
      tiles_(tiles_of({0, 0, width, height})),
      on_(static_cast<std::size_t>(tiles_.count())) {}

PixelBox TileMask::tiles_in(float left, float top, float right, float bottom) const {
  if (!(right > 0 && bottom > 0 && left < static_cast<float>(width_) && top < static_cast<float>(height_))) return {};
  const auto tile = [](float pixel, int last) { return clamped_index(pixel / tile_side, 0, last); };
  return {tile(left, tiles_.across - 1), tile(top, tiles_.down - 1), tile(right, tiles_.across - 1) + 1,
          tile(bottom, tiles_.down - 1) + 1};
}

void TileMask::add(float left, float top, float right, float bottom) {
  const PixelBox in = tiles_in(left, top, right, bottom);
  for (int y = in.top; y < in.bottom; ++y)
    for (int x = in.left; x < in.right; ++x) on_[at(x, y)] = 1;
}

void TileMask::add(const PixelBox& box) {
  if (box.left >= box.right || box.top >= box.bottom) return;
  add(static_cast<float>(box.left), static_cast<float>(box.top), static_cast<float>(box.right - 1),
      static_cast<float>(box.bottom - 1));
}

void TileMask::add(const TileMask& other) {
  std::transform(on_.begin(), on_.end(), other.on_.begin(), on_.begin(),
                 [](std::uint8_t a, std::uint8_t b) -> std::uint8_t { return a | b; });
}

bool TileMask::touches(float left, float top, float right, float bottom) const {
  const PixelBox in = tiles_in(left, top, right, bottom);
  for (int y = in.top; y < in.bottom; ++y)
    for (int x = in.left; x < in.right; ++x)
      if (on_[at(x, y)]) return true;
  return false;
}

PixelBox TileMask::bounds() const {
  PixelBox box{tiles_.across, tiles_.down, 0, 0};
  for (int y = 0; y < tiles_.down; ++y)
    for (int x = 0; x < tiles_.across; ++x)
      if (on_[at(x, y)])
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
  if (box.left >= box.right) return {};
  return {box.left * tile_side, box.top * tile_side, std::min(box.right * tile_side, width_),
          std::min(box.bottom * tile_side, height_)};
}

int TileMask::count() const { return static_cast<int>(std::count(on_.begin(), on_.end(), std::uint8_t{1})); }

}  // namespace pelage
