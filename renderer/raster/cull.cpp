#include "renderer/raster/cull.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr double fading = 0.125;  // share of the kept strands, the last ones, that become narrower

/// A ball around a part.
struct Ball {
  glm::vec3 middle{0};  // relative to the camera
  float radius = 0;
};

Ball ball_around(const RasterScene& scene, const GrownPart& part) {
  return {0.5f * (part.low + part.high) - scene.camera.position, 0.5f * glm::length(part.high - part.low)};
}

/// Returns the size of a pixel where a part is nearest, sizes.
double pixel_at(const RasterScene& scene, const GrownPart& part) {
  const float middle = glm::dot(part.middle - scene.camera.position, scene.camera.forward);
  return std::max(double{middle} - double{part.radius}, double{near_distance}) / scene.camera.scale;
}

/// Returns the width in pixels of a part's strands, for pixels of that size.
double width_at(const GrownPart& part, double pixel) { return 2 * double{part.strands->points[0].radius} / pixel; }

/// Returns the share of a part's strands that is kept, (0, 1]. Curves are placed on purpose and all kept.
double drawn_strand_share(const RasterScene& scene, const GrownPart& part) {
  if (part.role == StrandRole::curve) return 1;
  const double pixel = pixel_at(scene, part);
  const double on_a_pixel = static_cast<double>(part.strands->count()) / std::max(part.area, 1e-12) * pixel * pixel;
  RasterQuality quality = scene.quality;
  quality.strands_a_pixel *= double{part.unwound};
  return quality.drawn_strand_share(on_a_pixel, width_at(part, pixel));
}

/// Returns the cosine between a root's normal and the direction to the camera below which its strand stays behind the
/// body. Longer strands reach further around it.
float min_facing(const GrownPart& part) { return -std::min(0.25f + 8 * part.longest, 2.0f); }

}  // namespace

float drawn_beside(const RasterScene& scene, float thickest, float nearest) {
  constexpr double edge = 3, wider = deep_strand_factor / (1 - fading / 2);  // pixels of antialiasing; largest widening
  const double half = double{thickest} * double{scene.camera.scale} / double{std::max(nearest, near_distance)};
  return static_cast<float>(edge + wider * std::max(0.5 * scene.quality.widest(), half));
}

std::uint32_t strands_of_lit(const RasterScene& scene, const GrownPart& part) {
  if (part.role == StrandRole::curve || !is_coloured(scene.output)) return 1;
  const double wide = std::max(width_at(part, pixel_at(scene, part)) / double{part.wider}, 1.0);  // in the whole coat
  return static_cast<std::uint32_t>(std::max(scene.quality.lit_of / wide, 1.0));
}

std::uint32_t lit_strands(const RasterScene& scene, const GrownPart& part, std::uint32_t last) {
  return last / strands_of_lit(scene, part) + 1;
}

float own_colour(const RasterScene& scene, const GrownPart& part) {
  return static_cast<float>(std::sqrt(drawn_strand_share(scene, part) / double{part.wider}));
}

bool shows_in(const RasterScene& scene, const GrownPart& part, const PixelBox& box) {
  if (part.strands->count() == 0) return false;
  const PictureCamera& camera = scene.camera;
  const Ball ball = ball_around(scene, part);
  const float distance = glm::dot(ball.middle, camera.forward);
  if (distance < -ball.radius) return false;
  if (distance < 2 * ball.radius) return true;
  const float scale = camera.scale / distance;
  const float reach = ball.radius * camera.scale / (distance - ball.radius) +
                      drawn_beside(scene, part.thickest, distance - ball.radius);
  const float x = camera.middle.x + glm::dot(ball.middle, camera.right) * scale;
  const float y = camera.middle.y - glm::dot(ball.middle, camera.up) * scale;
  const float wider = 1 + std::abs(glm::dot(ball.middle, camera.right)) / distance +
                      std::abs(glm::dot(ball.middle, camera.up)) / distance;  // perspective elongates off-centre balls
  const float left = x - wider * reach, right = x + wider * reach, top = y - wider * reach, bottom = y + wider * reach;
  const bool inside = right > static_cast<float>(box.left) && left < static_cast<float>(box.right) &&
                      bottom > static_cast<float>(box.top) && top < static_cast<float>(box.bottom);
  return inside && (!scene.drawn || scene.drawn->touches(left, top, right, bottom));
}

StrandCull strand_cull(const RasterScene& scene, const GrownPart& part) {
  const auto all = static_cast<double>(part.strands->count());
  const double share = drawn_strand_share(scene, part);
  StrandCull cull;
  cull.thins = share < 1, cull.exact = share * all;
  cull.count = static_cast<std::uint32_t>(std::min(std::ceil(cull.exact), all));
  cull.width_factor = cull.thins ? 1 / (share * (1 - fading / 2)) : 1;
  cull.to_camera = glm::normalize(scene.camera.position - part.middle + glm::vec3(1e-9f));
  cull.min_facing = min_facing(part);
  return cull;
}

float StrandCull::widened(std::uint32_t strand) const {
  const double left = thins ? std::min((exact - strand) / (fading * exact), 1.0) : 1;
  return static_cast<float>(width_factor * left);
}

void keep_strands(const RasterScene& scene, const GrownPart& part, KeptStrands& kept) {
  kept.ids.clear(), kept.widened.clear();
  const StrandSet& set = *part.strands;
  const StrandCull cull = strand_cull(scene, part);
  for (std::uint32_t i = 0; i < cull.count; ++i)
    if (cull.faces(set.roots[i])) kept.ids.push_back(i), kept.widened.push_back(cull.widened(i));
}

}  // namespace pelage
