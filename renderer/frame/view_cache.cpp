#include "renderer/frame/view_cache.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "renderer/curves/curve_strips.h"

namespace pelage {

namespace {

/// Without what is done to the light once it is drawn, and without curves.
FurFrame light_of(const FurFrame& frame) {
  FurFrame light = frame;
  const FurFrame rest;
  light.background = rest.background, light.background_colour = rest.background_colour;
  light.exposure = rest.exposure, light.tone_map = rest.tone_map;
  light.overlay = rest.overlay, light.difference.clear();
  light.curves.clear();
  return light;
}

/// Whether both have the same light but for curves and the fields.
bool same_light(const FurFrame& a, const FurFrame& b) { return light_of(a) == light_of(b); }

/// Whether light is made a picture the same way.
bool same_finish(const FurFrame& a, const FurFrame& b) {
  return a.background == b.background && a.background_colour == b.background_colour && a.exposure == b.exposure &&
         a.tone_map == b.tone_map;
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
    const glm::vec3 place = strips.points[i];
    float reach = 0;
    if (i % each > 0) reach = glm::distance(place, strips.points[i - 1]);
    if (i % each < curve_segments) reach = std::max(reach, glm::distance(place, strips.points[i + 1]));
    const float width = std::max(strips.styles[curve].root.w, strips.styles[curve].tip.w);
    all = union_of(all, boxes.of(place, reach + width));
  }
}

}  // namespace

std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip) {
  if (before.curves == now.curves) return {};
  const CurveStrips old = make_strips(before.curves), other = make_strips(now.curves);
  const BallBoxes boxes(to_clip);
  std::optional<ClipBox> all;
  add_changes(old, other, boxes, all);
  add_changes(other, old, boxes, all);
  return all;
}

int kept_format(const FurFrame& frame) { return frame.overlay == Overlay::none ? 8 : 0; }

Image finish_view(const FurFrame& frame, const FinishInput& input, const Area& changed, CachedView& view) {
  if (kept_format(frame) == 0) return finish_picture(frame, input);
  if (view.shown->format == kept_format(frame)) {
    const Area finished = finished_area(changed, {view.light.width, view.light.height}, {frame.width, frame.height});
    finish_rows(frame, input, finished.top, finished.top + finished.height, view.picture);
  } else {
    view.picture = finish_picture(frame, input);
  }
  view.shown->format = kept_format(frame);
  return view.picture;
}

CachedView ViewCache::take(const FurFrame& frame, int format) {
  const auto shows = [&](const CachedView& view) { return view.shown && same_light(view.shown->frame, frame); };
  const auto found = std::find_if(views_.begin(), views_.end(), shows);
  if (found == views_.end()) {
    const bool spare = std::any_of(views_.begin(), views_.end(), [](const CachedView& view) { return !view.shown; });
    if (!spare && views_.size() < max_views) return {};
    CachedView view = take_out(victim());
    view.shown.reset(), view.came_back = false;
    return view;
  }
  CachedView view = take_out(found);
  if (view.shown->format != format || !same_finish(view.shown->frame, frame)) view.shown->format = 0;
  view.came_back = true;
  return view;
}

void ViewCache::keep(CachedView view) {
  if (view.pixels() > max_pixels) return;
  views_.push_front(std::move(view));
  std::int64_t pixels = 0;
  for (const CachedView& each : views_) pixels += each.pixels();
  while (views_.size() > max_views || pixels > max_pixels) pixels -= take_out(victim()).pixels();
}

// The last view is kept: two that are asked for in turn would push each other out before they come back.
ViewCache::Views::iterator ViewCache::victim() {
  assert(!views_.empty());
  const auto oldest = [&](auto first, auto unwanted) {
    const auto found = std::find_if(views_.rbegin(), std::make_reverse_iterator(first), unwanted);
    return found == std::make_reverse_iterator(first) ? views_.end() : std::prev(found.base());
  };
  const auto spare = oldest(views_.begin(), [](const CachedView& view) { return !view.shown; });
  if (spare != views_.end()) return spare;
  const auto once = oldest(std::next(views_.begin()), [](const CachedView& view) { return !view.came_back; });
  return once != views_.end() ? once : std::prev(views_.end());
}

CachedView ViewCache::take_out(Views::iterator view) {
  CachedView taken = std::move(*view);
  views_.erase(view);
  return taken;
}

}  // namespace pelage
