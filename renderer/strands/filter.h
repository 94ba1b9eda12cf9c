// Smooths a traced picture of few samples along what its features say is alike: a cross-bilateral filter whose widths
// follow the noise of the features (after Rousselle 2013). Light is averaged without the colour of what it falls on,
// which is put back after.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/image/float_image.h"

namespace pelage {

/// From so many samples a pixel on, nothing is changed.
inline constexpr std::uint32_t filtered_samples = 64;

/// Pixels to each side that a filtered pixel follows from.
inline constexpr int filter_margin = 9;

/// Means over a pixel's samples, rows from the top. Features are multiplied by body, depth is with the share of samples
/// that hit something.
struct FilterSource {
  int width = 0, height = 0;
  std::span<const std::uint32_t> samples;          // of each pixel
  std::span<const float> beauty;                   // 4 a pixel: radiance times alpha, alpha
  std::span<const float> body;                     // 1: alpha without the ground
  std::span<const float> depth;                    // 2
  std::span<const float> normal, tangent, albedo;  // 3
};

/// Returns beauty and alpha, averaged over up to 6 pixels to each side at 1 sample a pixel, over fewer by its
/// logarithm, and over none at 64. Pixels without body give and take no light, except silhouettes, which are smoothed
/// by their neighbours; the ground's shadow is smoothed by itself. The same bits for any number of threads; 0 stands
/// for one for each core.
FloatImage filter_beauty(const FilterSource& source, int threads = 0);

}  // namespace pelage
