#include "renderer/optics/eye_cache.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "base/clamped_index.h"

namespace pelage {

namespace {

constexpr std::size_t max_shapes = 4 * max_eyes;

/// Returns the next mip level: means of two by two texels.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& texels, int width, int height) {
  std::vector<std::uint8_t> half;
  for (int y = 0; y < height / 2; ++y) {
    for (int x = 0; x < width / 2; ++x) {
      for (int k = 0; k < 4; ++k) {
        const auto at = [&](int i, int j) {
          return int{
              texels[4 * static_cast<std::size_t>((2 * y + j) * width + 2 * x + i) + static_cast<std::size_t>(k)]};
        };
        half.push_back(static_cast<std::uint8_t>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
      }
    }
  }
  return half;
}

TissueLevels tissue_levels() {
  TissueLevels levels;
  std::vector<std::uint8_t> texels = make_iris_map();
  int width = iris_map_width, height = iris_map_height;
  for (std::int32_t& first : levels.first) {
    first = static_cast<std::int32_t>(levels.words.size());
    levels.words.resize(levels.words.size() + texels.size() / 4);
    std::memcpy(&levels.words[static_cast<std::size_t>(first)], texels.data(), texels.size());
    texels = halved(texels, width, height), width /= 2, height /= 2;
  }
  return levels;
}

/// Returns the pixels that an eye's bounding box may touch; all pixels if it reaches the near plane.
PixelBox box_of(const EyeEntry& eye, const glm::mat4& world_to_clip, glm::ivec2 size) {
  constexpr auto lids = static_cast<float>(lid_radius);
  const float side = 1.02f * lids, top = 1.02f * std::max(lids, eye.cornea.x + eye.cornea.y);
  glm::vec2 low(1e9f), high(-1e9f);
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 corner(k & 1 ? side : -side, k & 2 ? side : -side, k & 4 ? top : -side);
    const glm::vec3 position =
        glm::vec3(eye.position) + eye.right.w * (glm::mat3(eye.right, eye.up, eye.forward) * corner);
    const glm::vec4 clip = world_to_clip * glm::vec4(position, 1);
    if (!(clip.w > near_distance)) return {0, 0, size.x, size.y};
    const glm::vec2 at = (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(size);
    low = glm::min(low, at), high = glm::max(high, at);
  }
  const auto clamped = [](float at, int max) { return clamped_index(at, 0, max); };
  return {clamped(std::floor(low.x) - 1, size.x), clamped(std::floor(low.y) - 1, size.y),
          clamped(std::ceil(high.x) + 1, size.x), clamped(std::ceil(high.y) + 1, size.y)};
}

}  // namespace

EyeCamera eye_camera(const EyeEntry& eye, const FurCamera& camera, const glm::mat4& world_to_clip, glm::ivec2 size) {
  const glm::mat3 frame(eye.right, eye.up, eye.forward);
  return {(camera.position - glm::vec3(eye.position)) * frame / eye.right.w, camera.forward * frame,
          box_of(eye, world_to_clip, size)};
}

EyeCache::EyeCache() : tissues_(tissue_levels()) {}

int EyeCache::first_caustic_of(const EyeShape& shape) {
  const auto found = std::find(shapes_.begin(), shapes_.end(), shape);
  const int first = caustic_angles * static_cast<int>(found - shapes_.begin());
  if (found != shapes_.end()) return first;
  const std::vector<float> made = gather_caustics(shape);
  shapes_.push_back(shape), caustics_.insert(caustics_.end(), made.begin(), made.end());
  return first;
}

EyeOptics EyeCache::of(const FurFrame& frame) {
  assert(!frame.eyes.empty() && frame.eyes.size() <= max_eyes);
  if (shapes_.size() + frame.eyes.size() > max_shapes) shapes_.clear(), caustics_.clear();
  EyeOptics eyes;
  eyes.block.surroundings = {frame.background_colour, 1};
  for (std::size_t k = 0; k < frame.eyes.size(); ++k)
    eyes.block.eyes[k] = make_eye_entry(frame.eyes[k], frame, first_caustic_of(shape_of(frame.eyes[k])));
  eyes.steps = frame.knobs.eye_steps, eyes.tissues = &tissues_, eyes.caustics = caustics_;
  return eyes;
}

}  // namespace pelage
