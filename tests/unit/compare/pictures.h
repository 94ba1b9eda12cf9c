// Test pictures made by formulas, so that anybody can make them again.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/colour_space.h"
#include "renderer/compare/compare.h"

namespace pelage::pictures {

/// Finaliser of a 32-bit hash, so that noise is the same on every machine.
inline std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// An opaque picture of colour(x, y, k), which is in [0, 255] for k = 0, 1, 2.
template <class Colour>
Image drawn(int width, int height, Colour colour) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = 0; k < 3; ++k) image.rgba.push_back(static_cast<std::uint8_t>(colour(x, y, k)));
      image.rgba.push_back(255);
    }
  }
  return image;
}

/// Uniform noise in all channels.
inline Image noise(int width, int height, std::uint32_t seed) {
  return drawn(width, height, [&](int x, int y, int k) {
    return hash(seed + static_cast<std::uint32_t>((y * width + x) * 3 + k)) % 256;
  });
}

/// Soft colour gradients with a sharp disc and a bar: a picture with edges, flat parts and colours.
inline Image scene(int width, int height) {
  return drawn(width, height, [&](int x, int y, int k) {
    const int dx = x - width / 3, dy = y - height / 2;
    if (dx * dx + dy * dy < height * height / 16) return k == 0 ? 200 : k == 1 ? 150 : 40;
    if (x > 3 * width / 4 && x < 3 * width / 4 + 4) return k == 2 ? 230 : 20;
    return k == 0 ? 255 * x / width : k == 1 ? 255 * y / height : 128;
  });
}

/// Upright strands 1.2 pixels wide and 5.3 apart, moved right by `shift` pixels; each pixel shows its exact coverage.
inline Image strands(int width, int height, double shift) {
  return drawn(width, height, [&](int x, int, int k) {
    double covered = 0;
    for (double left = shift - 5.3; left < x + 1; left += 5.3) {
      covered += std::max(0.0, std::min(left + 1.2, x + 1.0) - std::max<double>(left, x));
    }
    const double tint[3] = {1, 0.8, 0.6};
    return std::lround(255 * srgb_from_linear((0.02 + 0.38 * covered) * tint[k]));
  });
}

inline Mask everywhere(int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(pixels, 1)};
}

/// Sets alpha to 255 inside a central disc and to 0 outside.
inline Image cut_to_disc(Image image, int radius) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int dx = x - image.width / 2, dy = y - image.height / 2;
      const std::size_t pixel = static_cast<std::size_t>(y * image.width + x);
      image.rgba[pixel * 4 + 3] = dx * dx + dy * dy <= radius * radius ? 255 : 0;
    }
  }
  return image;
}

}  // namespace pelage::pictures
