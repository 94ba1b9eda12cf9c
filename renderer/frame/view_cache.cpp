#include "renderer/frame/view_cache.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace pelage {

namespace {

/// Returns a frame without the settings that only affect how its light is finished.
FurFrame light_of(const FurFrame& frame) {
  FurFrame light = frame;
  const FurFrame defaults;
  light.background = defaults.background, light.background_colour = defaults.background_colour;
  light.exposure = defaults.exposure, light.tone_map = defaults.tone_map;
  light.overlay = defaults.overlay, light.difference.clear();
  return light;
}

/// Returns whether two frames have the same light, up to the model's fields.
bool same_light(const FurFrame& a, const FurFrame& b) { return light_of(a) == light_of(b); }

/// Returns whether two frames finish their light in the same way.
bool same_finish(const FurFrame& a, const FurFrame& b) {
  return a.background == b.background && a.background_colour == b.background_colour && a.exposure == b.exposure &&
         a.tone_map == b.tone_map;
}

}  // namespace

int cached_format(const FurFrame& frame) { return frame.overlay == Overlay::none ? 8 : 0; }

Image finish_view(const FurFrame& frame, const FinishInput& input, const Area& changed, CachedView& view) {
  if (cached_format(frame) == 0) return finish_picture(frame, input);
  if (view.shown->format == cached_format(frame)) {
    const Area finished = finished_area(changed, {view.light.width, view.light.height}, {frame.width, frame.height});
    finish_rows(frame, input, finished.top, finished.top + finished.height, view.picture);
  } else {
    view.picture = finish_picture(frame, input);
  }
  view.shown->format = cached_format(frame);
  return view.picture;
}

CachedView ViewCache::take(const FurFrame& frame, int format) {
  const auto shows = [&](const CachedView& view) { return view.shown && same_light(view.shown->frame, frame); };
  const auto found = std::find_if(views_.begin(), views_.end(), shows);
  if (found == views_.end()) {
    const bool spare = std::any_of(views_.begin(), views_.end(), [](const CachedView& view) { return !view.shown; });
    if (!spare && views_.size() < max_views) return {};
    CachedView view = take_out(victim());
    view.shown.reset(), view.requested_again = false;
    return view;
  }
  CachedView view = take_out(found);
  if (view.shown->format != format || !same_finish(view.shown->frame, frame)) view.shown->format = 0;
  view.requested_again = true;
  return view;
}

void ViewCache::keep(CachedView view) {
  if (view.pixels() > max_pixels) return;
  views_.push_front(std::move(view));
  std::int64_t pixels = 0;
  for (const CachedView& each : views_) pixels += each.pixels();
  while (views_.size() > max_views || pixels > max_pixels) pixels -= take_out(victim()).pixels();
}

// Spares the latest view: otherwise two views that are requested in turn would evict each other before they come back.
ViewCache::Views::iterator ViewCache::victim() {
  assert(!views_.empty());
  const auto oldest = [&](auto first, auto unwanted) {
    const auto found = std::find_if(views_.rbegin(), std::make_reverse_iterator(first), unwanted);
    return found == std::make_reverse_iterator(first) ? views_.end() : std::prev(found.base());
  };
  const auto spare = oldest(views_.begin(), [](const CachedView& view) { return !view.shown; });
  if (spare != views_.end()) return spare;
  const auto once = oldest(std::next(views_.begin()), [](const CachedView& view) { return !view.requested_again; });
  return once != views_.end() ? once : std::prev(views_.end());
}

CachedView ViewCache::take_out(Views::iterator view) {
  CachedView taken = std::move(*view);
  views_.erase(view);
  return taken;
}

}  // namespace pelage
