#include "renderer/finish/resize.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "base/parallel.h"

namespace pelage {

ResizedLight::ResizedLight(const FloatImage& light, int width, int height)
    : light_(light), width_(width), scale_(static_cast<float>(light.height) / static_cast<float>(height)) {
  for (int x = 0; x < width && scale_ < 1; ++x) columns_.push_back(taps(x, light.width));
}

ResizedLight::Taps ResizedLight::taps(int pixel, int size) const {
  const float at = (static_cast<float>(pixel) + 0.5f) * scale_ - 0.5f, start = std::floor(at);
  const float t = at - start, u = 1 - t;
  Taps taps;
  for (int k = 0; k < 4; ++k)
    taps.at[static_cast<std::size_t>(k)] = std::clamp(static_cast<int>(start) + k - 1, 0, size - 1);
  taps.weights = {-0.5f * t * u * u, 1 + t * t * (1.5f * t - 2.5f), 1 + u * u * (1.5f * u - 2.5f), -0.5f * u * t * t};
  return taps;
}

glm::vec4 ResizedLight::texel(int x, int y) const {
  const float* from = &light_.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(light_.width) +
                                        static_cast<std::size_t>(x))];
  return {from[0], from[1], from[2], from[3]};
}

/// Catmull-Rom interpolation without the four corners, whose weights are at most 1/256. The result is clamped to the
/// range of the four nearest pixels, so that it does not ring.
glm::vec4 ResizedLight::enlarged(const Taps& across, const Taps& down) const {
  const std::array<int, 4>&x = across.at, &y = down.at;
  const std::array<float, 4>&v = across.weights, &w = down.weights;
  const glm::vec4 a = texel(x[1], y[1]), b = texel(x[2], y[1]), c = texel(x[1], y[2]), d = texel(x[2], y[2]);
  const glm::vec4 low = glm::min(glm::min(a, b), glm::min(c, d)), high = glm::max(glm::max(a, b), glm::max(c, d));
  if (low == high) return low;
  glm::vec4 sum = w[1] * (v[1] * a + v[2] * b) + w[2] * (v[1] * c + v[2] * d);
  sum += w[0] * (v[1] * texel(x[1], y[0]) + v[2] * texel(x[2], y[0]));
  sum += w[1] * (v[0] * texel(x[0], y[1]) + v[3] * texel(x[3], y[1]));
  sum += w[2] * (v[0] * texel(x[0], y[2]) + v[3] * texel(x[3], y[2]));
  sum += w[3] * (v[1] * texel(x[1], y[3]) + v[2] * texel(x[2], y[3]));
  return glm::clamp(sum / (1 - (v[0] + v[3]) * (w[0] + w[3])), low, high);
}

/// Returns the mean of the light that a pixel of the picture covers.
glm::vec4 ResizedLight::mean(int x, int y) const {
  const glm::vec2 low = glm::vec2(x, y) * scale_, high = low + scale_;
  const glm::ivec2 begin(glm::floor(low)), end(glm::ceil(high));
  const auto share = [](int at, float from, float to) {
    return std::max(0.0f, std::min(to, static_cast<float>(at) + 1) - std::max(from, static_cast<float>(at)));
  };
  glm::vec4 sum(0);
  float total = 0;
  for (int j = begin.y; j < end.y; ++j) {
    for (int i = begin.x; i < end.x; ++i) {
      const float weight = share(i, low.x, high.x) * share(j, low.y, high.y);
      sum += weight * texel(std::clamp(i, 0, light_.width - 1), std::clamp(j, 0, light_.height - 1));
      total += weight;
    }
  }
  return sum / total;
}

void ResizedLight::row(int y, float* rgba) const {
  if (scale_ == 1 && light_.width == width_) {
    const std::size_t numbers = 4 * static_cast<std::size_t>(width_);
    std::memcpy(rgba, &light_.rgba[static_cast<std::size_t>(y) * numbers], numbers * sizeof(float));
    return;
  }
  const Taps down = taps(y, light_.height);
  for (int x = 0; x < width_; ++x) {
    const glm::vec4 pixel = scale_ < 1 ? enlarged(columns_[static_cast<std::size_t>(x)], down) : mean(x, y);
    std::memcpy(rgba + std::ptrdiff_t{4} * x, &pixel.x, sizeof pixel);
  }
}

FloatImage resized_light(const FloatImage& light, int width, int height, int threads) {
  const ResizedLight resized(light, width, height);
  FloatImage picture;
  picture.width = width, picture.height = height;
  const auto row_numbers = 4 * static_cast<std::size_t>(width);
  picture.rgba.resize(row_numbers * static_cast<std::size_t>(height));
  for_each_in_parallel(
      static_cast<std::uint32_t>(height),
      [&](std::uint32_t y) { resized.row(static_cast<int>(y), &picture.rgba[y * row_numbers]); }, threads);
  return picture;
}

}  // namespace pelage
