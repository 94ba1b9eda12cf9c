#include "renderer/image/float_image.h"

#include <algorithm>

#include "base/colour_space.h"

namespace pelage {

void make_linear_and_premultiplied(FloatImage& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) {
      image.rgba[i + k] = static_cast<float>(linear_from_srgb(image.rgba[i + k]) * image.rgba[i + 3]);
    }
  }
}

FloatImage linear_image(const Image& image) {
  FloatImage linear{image.width, image.height, std::vector<float>(image.rgba.size()), true};
  std::transform(image.rgba.begin(), image.rgba.end(), linear.rgba.begin(),
                 [](std::uint8_t value) { return static_cast<float>(value) * (1.0f / 255); });
  make_linear_and_premultiplied(linear);
  return linear;
}

std::vector<ExrPlane> rgba_planes(std::span<const float> rgba, ExrSample sample, const std::string& aov) {
  const std::string prefix = aov.empty() ? "" : aov + ".";
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < 4; ++k) planes.push_back({prefix + "RGBA"[k], rgba, k, 4, sample});
  return planes;
}

}  // namespace pelage
