// Pictures over a frame, pixel by pixel.
#pragma once

#include <cstring>

#include "protocol/base/parallel.h"
#include "renderer/image/float_image.h"

namespace pelage {

/// Calls pixel(x, y), which gives sRGB with straight alpha.
template <class Pixel>
FloatImage plain_overlay(int width, int height, int threads, const Pixel& pixel) {
  auto image = empty_picture<FloatImage>(width, height);
  image.display_referred = true;
  const auto draw_row = [&](std::uint32_t y) {
    float* row = &image.rgba[4 * std::size_t{y} * static_cast<std::size_t>(width)];
    for (int x = 0; x < width; ++x) {
      const glm::vec4 colour = pixel(x, static_cast<int>(y));
      std::memcpy(row + std::ptrdiff_t{4} * x, &colour.x, sizeof colour);
    }
  };
  for_each_in_parallel(static_cast<std::uint32_t>(height), draw_row, threads);
  return image;
}

}  // namespace pelage
