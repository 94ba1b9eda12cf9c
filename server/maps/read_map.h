// How pictures are read between the centres of their pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

namespace pelage {

/// The four pixels around a place and their weights, which add up to 1. Some may be the same pixel.
struct Taps {
  std::array<std::size_t, 4> pixels{};  // rows from the top
  std::array<double, 4> weights{};
};

/// Returns whether a place lies in the picture itself.
inline bool is_inside(glm::vec2 uv) { return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1; }

/// A coordinate in the picture repeated; both 0 and 1 stay where they are.
inline double wrapped(double x) { return x >= 0 && x <= 1 ? x : x - std::floor(x); }

/// Places outside [0, 1] are those of the picture repeated; at its edges the last pixel goes on.
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
