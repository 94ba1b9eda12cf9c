#include "renderer/optics/base_images.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>

#include "base/colour_space.h"

namespace pelage {

namespace {

constexpr int max_side = 4096;

/// Appends an image at another size, by its nearest texels.
void append(const ImageView& image, int width, int height, std::vector<std::int32_t>& texels) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>((y * image.height / height) * image.width + x * image.width / width);
      const std::uint8_t* rgba = &image.rgba[4 * at];
      texels.push_back(static_cast<std::int32_t>(rgba[0] | rgba[1] << 8 | rgba[2] << 16));
    }
  }
}

/// Returns the mean of four texels, computed in linear light.
std::int32_t mean_of(const std::array<std::int32_t, 4>& texels, const std::array<float, 256>& linear) {
  std::int32_t mean = 0;
  for (int shift = 0; shift < 24; shift += 8) {
    float sum = 0;
    for (const std::int32_t texel : texels) sum += linear[static_cast<std::size_t>(texel >> shift & 255)];
    const auto above = std::lower_bound(linear.begin(), linear.end(), sum / 4) - linear.begin();
    mean |= static_cast<std::int32_t>(std::min<std::ptrdiff_t>(above, 255)) << shift;
  }
  return mean;
}

}  // namespace

BaseImages::BaseImages(std::span<const ImageView> images) {
  if (images.empty()) return;
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linear_from_srgb(static_cast<float>(i) / 255);
  Level level;
  for (const ImageView& image : images)
    level.width = std::max(level.width, image.width), level.height = std::max(level.height, image.height);
  level.width = std::min(level.width, max_side), level.height = std::min(level.height, max_side);
  for (const ImageView& image : images) append(image, level.width, level.height, texels);
  levels.push_back(level);
  while (level.width > 1 || level.height > 1) {
    const Level finer = level;
    level = {std::max(1, finer.width / 2), std::max(1, finer.height / 2), static_cast<std::int32_t>(texels.size())};
    levels.push_back(level);
    for (std::size_t image = 0; image < images.size(); ++image) {
      const auto of_image = static_cast<std::size_t>(finer.first) +
                            image * static_cast<std::size_t>(finer.width) * static_cast<std::size_t>(finer.height);
      const auto texel = [&](int x, int y) {
        return texels[of_image + static_cast<std::size_t>(std::min(y, finer.height - 1) * finer.width +
                                                          std::min(x, finer.width - 1))];
      };
      for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x)
          texels.push_back(mean_of(
              {texel(2 * x, 2 * y), texel(2 * x + 1, 2 * y), texel(2 * x, 2 * y + 1), texel(2 * x + 1, 2 * y + 1)},
              linear));
      }
    }
  }
}

}  // namespace pelage
