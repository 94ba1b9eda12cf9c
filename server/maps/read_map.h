// Samples pictures bilinearly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

namespace pelage {

/// The four pixels around a position and their weights, which sum to 1. Some may be the same pixel.
struct Taps {
  std::array<std::size_t, 4> pixels{};  // rows from the top
  std::array<double, 4> weights{};
};

/// Returns whether a position lies in the picture itself.
inline bool is_inside(glm::vec2 uv) { return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1; }

/// Returns a coordinate wrapped to [0, 1], as in a picture that repeats; 0 and 1 are not changed.
inline double wrapped(double x) { return x >= 0 && x <= 1 ? x : x - std::floor(x); }

/// Returns the taps at a position. Outside [0, 1] the picture repeats, but its edge pixels are extended, not wrapped.
inline Taps taps_at(glm::vec2 uv, int width, int height) {
  const double x = wrapped(uv.x) * width - 0.5, y = (1 - wrapped(uv.y)) * height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto pixel = [&](double column, double row) {
    return static_cast<std::size_t>(std::clamp(row, 0.0, height - 1.0)) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(std::clamp(column, 0.0, width - 1.0));
  };
  const double dx = x - left, dy = y - top;
  return {{pixel(left, top), pixel(left + 1, top), pixel(left, top + 1), pixel(left + 1, top + 1)},
          {(1 - dx) * (1 - dy), dx * (1 - dy), (1 - dx) * dy, dx * dy}};
}

}  // namespace pelage
