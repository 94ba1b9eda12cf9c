#include "renderer/frame/raster_aovs.h"

#include <algorithm>
#include <vector>

#include "renderer/finish/resize.h"

namespace pelage {

RasterOutput output_of(Aov aov) {
  switch (aov) {
    case Aov::depth: return RasterOutput::depth;
    case Aov::position: return RasterOutput::distance;
    case Aov::normal: return RasterOutput::normal;
    case Aov::tangent: return RasterOutput::tangent;
    case Aov::albedo: return RasterOutput::albedo;
    case Aov::direct: return RasterOutput::direct;
    case Aov::shadow: return RasterOutput::shadow;
    case Aov::sample_count: return RasterOutput::count;
    case Aov::strand:
    case Aov::root: return RasterOutput::strand;
    case Aov::objects_1:
    case Aov::objects_2:
    case Aov::objects_3:
    case Aov::objects_4: return RasterOutput::objects;
    default: return RasterOutput::light;
  }
}

namespace {

/// Returns the point on a pixel's ray at a distance along the view.
glm::vec3 position_at(const FurFrame& frame, int x, int y, float distance) {
  const FurCamera& camera = frame.camera;
  const float over = 2 * camera.tan_half_fov / static_cast<float>(frame.height);
  const glm::vec2 off = (glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(frame.width, frame.height)) * over;
  return camera.position + distance * (camera.forward + off.x * camera.right - off.y * camera.up);
}

/// Returns the value of an AOV in a pixel, from the premultiplied mean of its output.
glm::vec4 ruled(const FurFrame& frame, Aov aov, glm::vec4 mean, int x, int y) {
  const float alpha = std::clamp(mean.a, 0.0f, 1.0f);
  const glm::vec3 rgb(mean);
  switch (aov) {
    case Aov::depth: return {mean.r, 0, 0, 1};
    case Aov::strand: return {rgb, 1};
    case Aov::position: return {alpha > 0 ? position_at(frame, x, y, mean.r / mean.a) : glm::vec3(0), alpha};
    case Aov::normal:
    case Aov::tangent: return {glm::dot(rgb, rgb) > 1e-12f ? glm::normalize(rgb) : glm::vec3(0), alpha};
    case Aov::shadow: return {glm::vec3(mean.g > 0 ? std::clamp(mean.r / mean.g, 0.0f, 1.0f) : 1), alpha};
    default: return mean;
  }
}

/// Resamples values that cannot be interpolated, such as strand numbers or a depth: takes the value at the middle of
/// each pixel.
FloatImage picked(const FloatImage& drawn, int width, int height) {
  auto picture = empty_picture<FloatImage>(width, height);
  const auto nearest = [](int at, int to, int from) { return std::min((2 * at + 1) * from / (2 * to), from - 1); };
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(nearest(y, height, drawn.height)) * static_cast<std::size_t>(drawn.width);
    for (int x = 0; x < width; ++x) {
      const std::size_t from = row + static_cast<std::size_t>(nearest(x, width, drawn.width));
      std::copy_n(&drawn.rgba[4 * from], 4,
                  &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(x))]);
    }
  }
  return picture;
}

/// Replaces the strand numbers in a picture by the root positions of those strands; alpha is 0 where there is no
/// strand.
void to_roots(std::span<const GrownPart> parts, FloatImage& picture) {
  std::vector<std::size_t> ends;  // number of the last strand of each part
  for (const GrownPart& part : parts) ends.push_back((ends.empty() ? 0 : ends.back()) + part.strands->count());
  for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
    const auto number = static_cast<std::size_t>(picture.rgba[at]);
    glm::vec4 root(0);
    if (number > 0) {
      const auto end = std::lower_bound(ends.begin(), ends.end(), number);
      const StrandSet& set = *parts[static_cast<std::size_t>(end - ends.begin())].strands;
      const std::size_t strand = number - 1 - (*end - set.count());
      root = {set.points[strand * static_cast<std::size_t>(set.segments + 1)].position, 1};
    }
    for (int k = 0; k < 4; ++k) picture.rgba[at + static_cast<std::size_t>(k)] = root[k];
  }
}

}  // namespace

FloatImage aov_picture(const FurFrame& frame, Aov aov, const FloatImage& drawn, std::span<const GrownPart> parts,
                       int threads) {
  const bool single = aov == Aov::depth || aov == Aov::strand || aov == Aov::root;
  FloatImage picture =
      single ? picked(drawn, frame.width, frame.height) : resized_light(drawn, frame.width, frame.height, threads);
  std::size_t at = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x, at += 4) {
      float* rgba = &picture.rgba[at];
      const glm::vec4 value = ruled(frame, aov, {rgba[0], rgba[1], rgba[2], rgba[3]}, x, y);
      for (int k = 0; k < 4; ++k) rgba[k] = value[k];
    }
  }
  if (aov == Aov::root) to_roots(parts, picture);
  return picture;
}

}  // namespace pelage
