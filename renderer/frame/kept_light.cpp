#include "renderer/frame/kept_light.h"

#include <algorithm>
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

// Integers, so that the cells cover the pixels and the other way round; one more on each side for what was rounded.
int first_pixel(int cell, int pixels) { return std::max(0, cell * pixels / cells_a_side - 1); }
int end_pixel(int cell, int pixels) { return std::min(pixels, (cell + 1) * pixels / cells_a_side + 2); }
int first_cell(int pixel, int pixels) { return std::max(0, pixel * cells_a_side / pixels - 1); }
int last_cell(int end, int pixels) { return std::min(cells_a_side - 1, end * cells_a_side / pixels + 1); }

}  // namespace

void KeptLight::keep(const FurFrame& frame) {
  if (changes_stay_near(frame)) frame_ = frame;
}

std::optional<FurFrame> KeptLight::take(const FurFrame& frame) {
  std::optional<FurFrame> kept = std::exchange(frame_, {});
  if (kept && changes_stay_near(frame) && light_of(*kept) == light_of(frame)) return kept;
  return {};
}

std::optional<CellBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip) {
  Balls balls;
  for (std::size_t i = 0; i < std::max(before.curves.size(), now.curves.size()); ++i) {
    const FurCurves* old = i < before.curves.size() ? &before.curves[i] : nullptr;
    const FurCurves* other = i < now.curves.size() ? &now.curves[i] : nullptr;
    if (old && other && *old == *other) continue;
    if (old) add_curves(*old, balls);
    if (other) add_curves(*other, balls);
  }
  std::optional<CellBox> all;
  for (const CellBox& box : cells_of_fur(to_clip, balls.middles, balls.radii)) all = union_of(all, box);
  return all;
}

PicturePart part_of(const std::optional<CellBox>& cells, int width, int height) {
  if (!cells) return {{}, {0, 0, -1, -1}};
  const int left = first_pixel(cells->left, width), right = end_pixel(cells->right, width);
  const int low = first_pixel(cells->low, height), high = end_pixel(cells->high, height);  // from below
  return {{left, height - high, right - left, high - low},
          {first_cell(left, width), first_cell(low, height), last_cell(right, width), last_cell(high, height)}};
}

}  // namespace pelage
