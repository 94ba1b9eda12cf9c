#include "renderer/strands/trace_scene.h"

#include <algorithm>
#include <cmath>

#include "base/clamped_index.h"
#include "base/colour_space.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr float eye_margin = 1.25f;  // lids and cornea lie within this many radii of an eye's centre

/// Optical depth of one black strand: it transmits 1/7 of the light. Pale strands absorb less (World::transmittance).
/// With 1.25, twelve scenes were .65 to .99 as bright in detailed shells as in strands; with 3 they were .71 to 1.15.
constexpr float strand_depth = 2.0f;

constexpr float brightest_over_light = 16;

glm::vec4 texel(const FloatImage& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

}  // namespace

TraceScene::TraceScene(const FurFrame& frame, Backplate base, std::shared_ptr<const StrandShading> shading)
    : frame_(frame),
      base_(std::move(base)),
      lights_(frame.lights, frame.environment, frame.look.ambient),
      shading_(std::move(shading)),
      self_shadow_(strand_depth * static_cast<float>(frame.look.self_shadow)) {
  float received = lights_.mean_environment();
  for (const FurLight& light : frame.lights) received += luminance(light.radiance);
  brightest_ = brightest_over_light * std::max(received, 1e-6f);
}

std::size_t TraceScene::backplate_bytes() const {
  std::size_t numbers = 0;
  for (const FloatImage* image : {&base_.beauty, &base_.direct, &base_.albedo, &base_.normal, &base_.depth})
    numbers += image->rgba.size();
  return numbers * sizeof(float);
}

Ray TraceScene::ray_at(glm::vec2 position) const {
  const FurCamera& camera = frame_.camera;
  const glm::vec2 size(frame_.width, frame_.height);
  const glm::vec2 off = (position * 2.0f - size) / size.y * camera.tan_half_fov;
  return {.origin = camera.position,
          .direction = glm::normalize(camera.forward + camera.right * off.x - camera.up * off.y)};
}

float TraceScene::pixel_at(float distance) const {
  return 2 * frame_.camera.tan_half_fov / static_cast<float>(frame_.height) * distance;
}

BackplatePixel TraceScene::backplate_at(glm::vec2 position) const {
  const FloatImage& beauty = base_.beauty;
  const auto scale = static_cast<float>(beauty.width) / static_cast<float>(frame_.width);
  const int x = clamped_index(position.x * scale, 0, beauty.width - 1);
  const int y = clamped_index(position.y * scale, 0, beauty.height - 1);
  const glm::vec4 light = texel(beauty, x, y);
  const float over = texel(base_.depth, x, y).x;
  if (!(light.a > 0.5f) || !(over > 0)) return {};
  const glm::vec3 direct(texel(base_.direct, x, y));
  const glm::vec3 normal(texel(base_.normal, x, y)), albedo(texel(base_.albedo, x, y));
  const float length = glm::length(normal);
  if (!std::isfinite(glm::dot(glm::vec3(light) + direct + albedo, glm::vec3(1)) + length + over)) return {};
  return {.there = true,
          .distance = 1 / over,
          .ambient = glm::max(glm::vec3(light) - direct, 0.0f),
          .direct = direct,
          .albedo = albedo,
          .normal = length > 1e-6f ? normal / length : -frame_.camera.forward};
}

bool TraceScene::near_eye(const Ray& ray) const {
  return std::any_of(frame_.eyes.begin(), frame_.eyes.end(), [&](const FurEye& eye) {
    const glm::vec3 to_camera = eye.position - ray.origin;
    const float along = glm::dot(to_camera, ray.direction), square = glm::dot(to_camera, to_camera) - along * along;
    const float margin = eye_margin * eye.radius;
    return square < margin * margin && along > -margin;
  });
}

}  // namespace pelage
