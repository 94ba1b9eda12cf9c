// Cropping of pictures, and its inverse.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "renderer/image/image.h"

namespace pelage {

/// Returns a rectangle of a picture in memory (Image, Image16, FloatImage), by pixels from the left and the top; it
/// must lie inside of the picture.
template <class Picture>
Picture cropped(const Picture& whole, int left, int top, int width, int height) {
  assert(left >= 0 && top >= 0 && left + width <= whole.width && top + height <= whole.height);
  auto part = empty_picture<Picture>(width, height);
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    const std::size_t from = static_cast<std::size_t>(top + y) * static_cast<std::size_t>(whole.width);
    std::copy_n(&whole.rgba[4 * (from + static_cast<std::size_t>(left))], row,
                &part.rgba[static_cast<std::size_t>(y) * row]);
  }
  return part;
}

/// Returns a picture of that size that has `part` at a position and is 0 elsewhere.
template <class Picture>
Picture placed(const Picture& part, int left, int top, int width, int height) {
  assert(left >= 0 && top >= 0 && left + part.width <= width && top + part.height <= height);
  auto whole = empty_picture<Picture>(width, height);
  const std::size_t row = 4 * static_cast<std::size_t>(part.width);
  for (int y = 0; y < part.height; ++y) {
    const std::size_t to = static_cast<std::size_t>(top + y) * static_cast<std::size_t>(width);
    std::copy_n(&part.rgba[static_cast<std::size_t>(y) * row], row,
                &whole.rgba[4 * (to + static_cast<std::size_t>(left))]);
  }
  return whole;
}

}  // namespace pelage
