#include <algorithm>
#include <cmath>
#include <utility>

#include "server/maps/bilinear.h"
#include "server/maps/map_image.h"

namespace pelage {

namespace {

constexpr int most_passes = 48;
constexpr double close_enough = 1e-6;  // of a value's own size, or of 0.01 where it is smaller
constexpr double least_hold = 0.05;    // of covered pixels on a corner; with less a correction would grow beyond measure

/// One corner's equation: what its four pixels give together.
struct Equation {
  Taps taps;
  double hold = 0;  // sum of the squared weights of covered pixels
};

/// The sum of weights of one pixel that stands for several of the four.
Taps merged(Taps taps) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      if (taps.pixels[i] == taps.pixels[k]) taps.weights[i] += std::exchange(taps.weights[k], 0.0);
    }
  }
  return taps;
}

Equation equation_of(glm::vec2 uv, const MapImage& image) {
  Equation equation{merged(taps_at(uv, image.size, image.size))};
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = equation.taps.weights[i];
    if (image.covered[equation.taps.pixels[i]]) equation.hold += weight * weight;
  }
  return equation;
}

/// Moves the pixels the shortest way to where the equation holds. Whether it did not hold before.
bool project(const Equation& equation, double wanted, int channel, double least, double most, MapImage& image) {
  double found = 0;
  for (std::size_t i = 0; i < 4; ++i) found += equation.taps.weights[i] * image.at(equation.taps.pixels[i])[channel];
  const double miss = wanted - found;
  if (std::abs(miss) <= close_enough * std::max(std::abs(wanted), 0.01)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!image.covered[equation.taps.pixels[i]] || equation.taps.weights[i] == 0) continue;
    float& value = image.at(equation.taps.pixels[i])[channel];
    value = static_cast<float>(std::clamp(value + miss * equation.taps.weights[i] / equation.hold, least, most));
  }
  return true;
}

}  // namespace

void fit_corners(const UvCorners& uvs, std::span<const glm::vec4> values, glm::dvec4 least, glm::dvec4 most,
                 MapImage& image) {
  bool moved = true;
  for (int pass = 0; pass < most_passes && moved; ++pass) {
    moved = false;
    for (std::size_t k = 0; k < uvs.corners.size(); ++k) {
      if (!uvs.corners[k].mapped || !is_inside(uvs.corners[k].uv)) continue;
      const Equation equation = equation_of(uvs.corners[k].uv, image);
      if (equation.hold < least_hold) continue;
      for (int c = 0; c < image.channels; ++c)
        moved = project(equation, values[k][c], c, least[c], most[c], image) || moved;
    }
  }
}

}  // namespace pelage
