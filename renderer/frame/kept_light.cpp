#include "renderer/frame/kept_light.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "renderer/frame/shadow_maps.h"

namespace pelage {

namespace {

bool changes_stay_near(const FurFrame& frame) {
  const Knobs& knobs = frame.knobs;
  return knobs.order == FragmentOrder::layers && !knobs.fins && knobs.guard_hairs == 0 && !ShadowMaps::wanted(frame) &&
         frame.overlay == Overlay::none;
}

/// Without what is done to the light once it is drawn, and without curves.
FurFrame light_of(const FurFrame& frame) {
  FurFrame light = frame;
  const FurFrame rest;
  light.background = rest.background, light.background_colour = rest.background_colour;
  light.exposure = rest.exposure, light.tone_map = rest.tone_map;
  light.curves.clear();
  return light;
}

/// Balls that hold all curves of a group.
struct Balls {
  std::vector<glm::vec3> middles;
  std::vector<float> radii;
};

// Guides leave the line between two of their points by less than a third of what lies between points (Catmull and Rom
// 1974); what is filled in strays around its root (renderer/curves/curve_strips.h).
void add_curves(const FurCurves& group, Balls& balls) {
  const double width = std::max(group.width_root, group.width_tip);
  for (const FurGuide& guide : group.guides) {
    double length = 0;
    for (std::size_t i = 1; i < guide.points.size(); ++i)
      length = std::max(length, glm::distance(guide.points[i], guide.points[group.spread > 0 ? 0 : i - 1]));
    const double strayed = group.spread > 0 ? 2 : 1.0 / 3;
    for (const glm::dvec3& point : guide.points) {
      balls.middles.emplace_back(point);
      balls.radii.push_back(static_cast<float>(strayed * length + width));
    }
  }
}

/// One pixel more on each side for what was rounded.
glm::ivec2 pixels_of(float low, float high, int pixels) {
  const auto pixel = [&](float clip) { return std::clamp((clip * 0.5f + 0.5f), 0.0f, 1.0f) * static_cast<float>(pixels); };
  return {std::max(0, static_cast<int>(pixel(low)) - 1), std::min(pixels, static_cast<int>(pixel(high)) + 2)};
}

/// All that hold one of the pixels, and one more on each side.
glm::ivec2 cells_of(glm::ivec2 range, int pixels) {
  const auto cell = [&](int pixel) { return static_cast<int>(std::int64_t{pixel} * cells_a_side / pixels); };
  return {std::max(0, cell(range.x) - 1), std::min(cells_a_side - 1, cell(range.y) + 1)};
}

}  // namespace

void KeptLight::keep(const FurFrame& frame) {
  if (changes_stay_near(frame)) frame_ = frame;
}

std::optional<FurFrame> KeptLight::take(const FurFrame& frame) {
  std::optional<FurFrame> kept = std::exchange(frame_, {});
  if (kept && changes_stay_near(frame) && light_of(*kept) == light_of(frame)) return kept;
  return {};
}

std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip) {
  Balls balls;
  for (std::size_t i = 0; i < std::max(before.curves.size(), now.curves.size()); ++i) {
    const FurCurves* old = i < before.curves.size() ? &before.curves[i] : nullptr;
    const FurCurves* other = i < now.curves.size() ? &now.curves[i] : nullptr;
    if (old && other && *old == *other) continue;
    if (old) add_curves(*old, balls);
    if (other) add_curves(*other, balls);
  }
  const BallBoxes boxes(to_clip);
  std::optional<ClipBox> all;
  for (std::size_t i = 0; i < balls.middles.size(); ++i) all = union_of(all, boxes.of(balls.middles[i], balls.radii[i]));
  return all;
}

PicturePart part_of(const std::optional<ClipBox>& box, int width, int height) {
  if (!box) return {{}, {0, 0, -1, -1}};
  const glm::ivec2 across = pixels_of(box->low.x, box->high.x, width), up = pixels_of(box->low.y, box->high.y, height);
  const glm::ivec2 columns = cells_of(across, width), rows = cells_of(up, height);
  return {{across.x, height - up.y, across.y - across.x, up.y - up.x}, {columns.x, rows.x, columns.y, rows.y}};
}

}  // namespace pelage
