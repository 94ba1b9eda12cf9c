#include "renderer/frame/marched_aovs.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "renderer/finish/resize.h"

namespace pelage {

namespace {

/// Which rows of AovPixel an AOV shows, and in what follows its mean is changed.
enum class Rule { mean, straight, unit, light_share };

struct AovPlan {
  int first = 0, rows = 3;
  Rule rule = Rule::mean;
};

AovPlan plan_of(Aov aov) {
  switch (aov) {
    case Aov::position: return {AovRows::position, 3, Rule::straight};
    case Aov::normal: return {AovRows::normal, 3, Rule::unit};
    case Aov::tangent: return {AovRows::tangent, 3, Rule::unit};
    case Aov::albedo: return {AovRows::albedo, 3, Rule::mean};
    case Aov::direct: return {AovRows::direct, 3, Rule::mean};
    case Aov::shadow: return {AovRows::kept, 2, Rule::light_share};
    default: return {AovRows::count_of_segments, 1, Rule::mean};
  }
}

FloatImage rows_of(const MarchedAovs& drawn, const AovPlan& plan) {
  FloatImage image;
  image.width = drawn.light.width, image.height = drawn.light.height;
  image.rgba.resize(4 * drawn.pixels.size());
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    const AovPixel& pixel = drawn.pixels[i];
    std::memcpy(&image.rgba[4 * i], &pixel[static_cast<std::size_t>(plan.first)],
                static_cast<std::size_t>(plan.rows) * sizeof(float));
    image.rgba[4 * i + 3] = pixel[AovRows::cover];
  }
  return image;
}

glm::vec4 ruled(Rule rule, glm::vec4 sum) {
  const float alpha = std::clamp(sum.a, 0.0f, 1.0f);
  const glm::vec3 rgb(sum);
  switch (rule) {
    case Rule::mean: return sum;
    case Rule::straight: return {alpha > 0 ? rgb / sum.a : glm::vec3(0), alpha};
    case Rule::unit: return {glm::dot(rgb, rgb) > 1e-12f ? glm::normalize(rgb) : glm::vec3(0), alpha};
    case Rule::light_share: return {glm::vec3(sum.g > 0 ? std::clamp(sum.r / sum.g, 0.0f, 1.0f) : 1), alpha};
  }
  return sum;
}

/// 1 over the distance in the middle of each pixel of a picture.
FloatImage inverse_distances(const MarchedAovs& drawn, int width, int height) {
  FloatImage image;
  image.width = width, image.height = height;
  image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const float scale = static_cast<float>(drawn.light.height) / static_cast<float>(height);
  const auto at = [&](int pixel, int count) {
    return std::min(static_cast<int>((static_cast<float>(pixel) + 0.5f) * scale), count - 1);
  };
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(at(y, drawn.light.height)) * static_cast<std::size_t>(drawn.light.width);
    for (int x = 0; x < width; ++x) {
      const AovPixel& pixel = drawn.pixels[row + static_cast<std::size_t>(at(x, drawn.light.width))];
      float* to =
          &image
               .rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
      to[0] = pixel[AovRows::inverse], to[3] = 1;
    }
  }
  return image;
}

}  // namespace

FloatImage aov_picture(const MarchedAovs& drawn, Aov aov, int width, int height, int threads) {
  if (aov == Aov::beauty || aov == Aov::alpha) return resized_light(drawn.light, width, height, threads);
  if (aov == Aov::depth) return inverse_distances(drawn, width, height);
  const AovPlan plan = plan_of(aov);
  FloatImage picture = resized_light(rows_of(drawn, plan), width, height, threads);
  for (std::size_t i = 0; plan.rule != Rule::mean && i < picture.rgba.size(); i += 4) {
    float* pixel = &picture.rgba[i];
    const glm::vec4 value = ruled(plan.rule, {pixel[0], pixel[1], pixel[2], pixel[3]});
    std::memcpy(pixel, &value.x, sizeof value);
  }
  return picture;
}

FurFrame backplate_frame(const FurFrame& frame) {
  constexpr int max_pixels = 2048;  // along a side, of a picture that is larger than its frame
  const int factor = 2 * std::max(frame.width, frame.height) <= max_pixels ? 2 : 1;
  FurFrame open = frame;
  open.width *= factor, open.height *= factor, open.crop.reset();
  open.knobs = {};
  open.knobs.scale = 1, open.knobs.self_shadow = false, open.knobs.shadow_maps = false;
  open.knobs.eye_steps = frame.knobs.eye_steps;
  open.ground.reset();
  open.curves.clear();
  return open;
}

Backplate backplate_of(MarchedAovs drawn, int threads) {
  const int width = drawn.light.width, height = drawn.light.height;
  const auto picture = [&](Aov aov) { return aov_picture(drawn, aov, width, height, threads); };
  Backplate base{{}, picture(Aov::direct), picture(Aov::albedo), picture(Aov::normal), picture(Aov::depth)};
  base.beauty = std::move(drawn.light);
  return base;
}

}  // namespace pelage
