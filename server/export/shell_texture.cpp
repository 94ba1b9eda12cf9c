#include "server/export/shell_texture.h"

#include <algorithm>
#include <cmath>

#include "base/colour_space.h"

namespace pelage {

SliceBin bin_of(int shell, int shell_count) {
  return {shell * slice_count / shell_count, (shell + 1) * slice_count / shell_count, (shell + 0.5) / shell_count};
}

ShellTexture::ShellTexture(const SliceLevel& level, const SliceBin& bin) : texels_(level.texels) {
  const std::size_t count = static_cast<std::size_t>(level.texels) * static_cast<std::size_t>(level.texels);
  opacity_.resize(count), lightness_.resize(count);
  double depths = 0, light = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double depth = 0, sum = 0;
    for (int slice = bin.first; slice < bin.last; ++slice) {
      const std::size_t texel = 4 * (static_cast<std::size_t>(slice) * count + i);
      const double here = level.shape[texel + 3] / 255.0 * stored_depth * level.depth_scale[0];
      for (std::size_t k = 0; k < 3; ++k) {
        const double root = level.colour[texel + k] / 255.0;  // stored as the root of linear
        sum += here * root * root / 3;
      }
      depth += here;
    }
    opacity_[i] = static_cast<float>(1 - std::exp(-depth));
    lightness_[i] = static_cast<float>(depth > 0 ? sum / depth : 0);
    depths += depth, light += sum;
  }
  const auto mean = static_cast<float>(depths > 0 ? light / depths : 0);
  for (float& value : lightness_) value = mean > 0 ? value / mean : 1;
}

Image ShellTexture::image() const {
  Image image{texels_, texels_, {}};
  image.rgba.reserve(4 * opacity_.size());
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  for (std::size_t i = 0; i < opacity_.size(); ++i) {
    const std::uint8_t grey = byte(srgb_from_linear(double{std::min(lightness_[i] / headroom, 1.0f)}));
    for (int k = 0; k < 3; ++k) image.rgba.push_back(grey);
    image.rgba.push_back(byte(double{opacity_[i]}));
  }
  return image;
}

}  // namespace pelage
