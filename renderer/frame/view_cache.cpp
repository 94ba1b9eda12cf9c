#include "renderer/frame/view_cache.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "renderer/curves/curve_strips.h"
#include "renderer/frame/shadow_maps.h"

namespace pelage {

namespace {

/// Without what is done to the light once it is drawn, and without curves.
FurFrame light_of(const FurFrame& frame) {
  FurFrame light = frame;
  const FurFrame rest;
  light.background = rest.background, light.background_colour = rest.background_colour;
  light.exposure = rest.exposure, light.tone_map = rest.tone_map;
  light.curves.clear();
  return light;
}

/// Adds the places of one group's curves that are not as in the other's, with what lies next to them.
void add_changes(const CurveStrips& strips, const CurveStrips& other, const BallBoxes& boxes,
                 std::optional<ClipBox>& all) {
  constexpr std::size_t each = curve_segments + 1;
  for (std::size_t i = 0; i < strips.points.size(); ++i) {
    const std::size_t curve = i / each;
    const bool same =
        i < other.points.size() && strips.points[i] == other.points[i] && strips.styles[curve] == other.styles[curve];
    if (same) continue;
    const glm::vec3 place = strips.points[i].place;
    float reach = 0;
    if (i % each > 0) reach = glm::distance(place, strips.points[i - 1].place);
    if (i % each < curve_segments) reach = std::max(reach, glm::distance(place, strips.points[i + 1].place));
    const float width = std::max(strips.styles[curve].root.w, strips.styles[curve].tip.w);
    all = union_of(all, boxes.of(place, reach + width));
  }
}

/// One pixel more on each side for what was rounded.
glm::ivec2 pixels_of(float low, float high, int pixels) {
  const auto pixel = [&](float clip) {
    return std::clamp((clip * 0.5f + 0.5f), 0.0f, 1.0f) * static_cast<float>(pixels);
  };
  return {std::max(0, static_cast<int>(pixel(low)) - 1), std::min(pixels, static_cast<int>(pixel(high)) + 2)};
}

/// All that hold one of the pixels, and one more on each side.
glm::ivec2 cells_in(glm::ivec2 range, int pixels) {
  const auto cell = [&](int pixel) { return static_cast<int>(std::int64_t{pixel} * cells_a_side / pixels); };
  return {std::max(0, cell(range.x) - 1), std::min(cells_a_side - 1, cell(range.y) + 1)};
}

// The cubic of Catmull and Rom reads two pixels to each side.
glm::ivec2 finished_range(int begin, int length, int light, int picture) {
  const double scale = static_cast<double>(picture) / light;
  return {std::max(0, static_cast<int>(std::floor((begin - 2) * scale)) - 1),
          std::min(picture, static_cast<int>(std::ceil((begin + length + 2) * scale)) + 1)};
}

}  // namespace

bool changes_stay_near(const FurFrame& frame) {
  const Knobs& knobs = frame.knobs;
  return knobs.order == FragmentOrder::shells && !knobs.fins && knobs.guard_hairs == 0 && !ShadowMaps::wanted(frame) &&
         frame.overlay == Overlay::none;
}

bool same_light(const FurFrame& a, const FurFrame& b) { return light_of(a) == light_of(b); }

bool same_finish(const FurFrame& a, const FurFrame& b) {
  return a.background == b.background && a.background_colour == b.background_colour && a.exposure == b.exposure &&
         a.tone_map == b.tone_map;
}

std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip) {
  if (before.curves == now.curves) return {};
  const CurveStrips old = make_strips(before.curves), other = make_strips(now.curves);
  const BallBoxes boxes(to_clip);
  std::optional<ClipBox> all;
  add_changes(old, other, boxes, all);
  add_changes(other, old, boxes, all);
  return all;
}

Area area_of(const std::optional<ClipBox>& box, int width, int height) {
  if (!box) return {};
  const glm::ivec2 across = pixels_of(box->low.x, box->high.x, width), up = pixels_of(box->low.y, box->high.y, height);
  return {across.x, height - up.y, across.y - across.x, up.y - up.x};
}

CellBox cells_of(const Area& area, int width, int height) {
  if (area.pixels() == 0) return {0, 0, -2, -2};
  const int low = height - area.top - area.height;
  const glm::ivec2 columns = cells_in({area.left, area.left + area.width}, width);
  const glm::ivec2 rows = cells_in({low, low + area.height}, height);
  return {columns.x, rows.x, columns.y, rows.y};
}

Area finished_area(const Area& area, glm::ivec2 light, glm::ivec2 picture) {
  const glm::ivec2 across = finished_range(area.left, area.width, light.x, picture.x);
  const glm::ivec2 down = finished_range(area.top, area.height, light.y, picture.y);
  return {across.x, down.x, across.y - across.x, down.y - down.x};
}

}  // namespace pelage
