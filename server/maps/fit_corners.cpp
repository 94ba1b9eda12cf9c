#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "server/maps/bilinear.h"
#include "server/maps/map_image.h"

namespace pelage {

namespace {

constexpr std::size_t least_passes = 48, most_passes = 2000;
constexpr std::size_t most_corrections = 10'000'000;  // beyond the least passes: small models may take more of them
constexpr double close_enough = 1e-6;  // of a value's own size, or of 0.01 where it is smaller
constexpr double least_hold = 0.05;    // of covered pixels on a corner; with less a correction would grow too far

/// The sum of weights of one pixel that stands for several of the four.
Taps merged(Taps taps) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      if (taps.pixels[i] == taps.pixels[k]) taps.weights[i] += std::exchange(taps.weights[k], 0.0);
    }
  }
  return taps;
}

/// What a corner's four pixels give now.
double found(const Taps& taps, int channel, const MapImage& image) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += taps.weights[i] * image.at(taps.pixels[i])[channel];
  return sum;
}

/// The sum of the squared weights of covered pixels: how well a corner can be corrected.
double hold_of(const Taps& taps, const MapImage& image) {
  double hold = 0;
  for (std::size_t i = 0; i < 4; ++i) hold += image.covered[taps.pixels[i]] * taps.weights[i] * taps.weights[i];
  return hold;
}

/// Whether a pixel can go on in the direction of `miss`.
bool is_free(const MapImage& image, std::size_t pixel, int channel, double miss, double least, double most) {
  const double value = image.at(pixel)[channel];
  return image.covered[pixel] && (miss > 0 ? value < most : value > least);
}

/// Moves the free pixels the shortest way to where the corner's equation holds, and those that then still are free
/// again where others came to a limit. Whether it did not hold before.
bool project(const Taps& taps, double wanted, int channel, double least, double most, MapImage& image) {
  const double enough = close_enough * std::max(std::abs(wanted), 0.01);
  double miss = wanted - found(taps, channel, image);
  if (std::abs(miss) <= enough) return false;
  for (int round = 0; round < 4 && std::abs(miss) > enough; ++round) {
    double hold = 0;  // sum of the squared weights of free pixels
    std::array<bool, 4> free{};
    for (std::size_t i = 0; i < 4; ++i) {
      free[i] = is_free(image, taps.pixels[i], channel, miss, least, most);
      if (free[i]) hold += taps.weights[i] * taps.weights[i];
    }
    if (hold == 0) return true;
    for (std::size_t i = 0; i < 4; ++i) {
      float& value = image.at(taps.pixels[i])[channel];
      if (free[i]) value = static_cast<float>(std::clamp(value + miss * taps.weights[i] / hold, least, most));
    }
    miss = wanted - found(taps, channel, image);
  }
  return true;
}

}  // namespace

void fit_corners(const UvCorners& uvs, std::span<const glm::vec4> values, glm::dvec4 least, glm::dvec4 most,
                 MapImage& image) {
  const std::size_t passes =
      std::clamp(most_corrections / std::max<std::size_t>(uvs.corners.size(), 1), least_passes, most_passes);
  bool moved = true;
  for (std::size_t pass = 0; pass < passes && moved; ++pass) {
    moved = false;
    for (std::size_t k = 0; k < uvs.corners.size(); ++k) {
      if (!uvs.corners[k].mapped) continue;
      const Taps taps = merged(taps_at(uvs.corners[k].uv, image.size, image.size));
      if (hold_of(taps, image) < least_hold) continue;
      for (int c = 0; c < image.channels; ++c)
        moved = project(taps, values[k][c], c, least[c], most[c], image) || moved;
    }
  }
}

}  // namespace pelage
