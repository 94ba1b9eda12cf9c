// Denoises a traced picture of few samples: a cross-bilateral filter guided by features, whose widths follow the noise
// of the features (after Rousselle 2013). Light is divided by albedo before it is averaged, and multiplied again after.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/image/float_image.h"

namespace pelage {

/// Pixels with at least this many samples are not filtered.
inline constexpr std::uint32_t filtered_samples = 64;

/// A filtered pixel depends on pixels up to this far away, in pixels.
inline constexpr int filter_margin = 9;

/// Means over each pixel's samples, rows from the top. Features are premultiplied by body; depth comes with the share
/// of samples that hit something.
struct FilterSource {
  int width = 0, height = 0;
  std::span<const std::uint32_t> samples;          // for each pixel
  std::span<const float> beauty;                   // 4 numbers a pixel: premultiplied radiance, alpha
  std::span<const float> body;                     // 1 number: alpha without the ground
  std::span<const float> depth;                    // 2 numbers: 1 / distance, share of hits
  std::span<const float> normal, tangent, albedo;  // 3 numbers
};

/// Returns filtered beauty and alpha. The filter's radius is 6 pixels at 1 sample a pixel, falls with the logarithm of
/// the number of samples, and is 0 at 64. Pixels without body neither give nor take light, except at silhouettes, which
/// are smoothed with their neighbours; the ground's shadow is smoothed separately. Deterministic for any number of
/// threads; 0 stands for one for each core.
FloatImage filter_beauty(const FilterSource& source, int threads = 0);

}  // namespace pelage
