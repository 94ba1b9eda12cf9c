// The last views and the targets that show them. A stroke changes a part of the body: when a view is drawn again, the
// same but for the fields of some vertices and what stands on them, only the part of the picture that these may reach
// is drawn.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <list>
#include <optional>
#include <utility>

#include "renderer/input/fur_scene.h"
#include "renderer/passes/sorted/sorted_pass.h"
#include "renderer/visibility/picture_cells.h"

namespace pelage {

struct ShownFrame {
  FurFrame frame;
  int format = 0;             // of the finished picture, 0 where it is not this frame's
  std::uint64_t changes = 0;  // of the model (ChangedFur::count) when it was drawn
};

/// Whether a change of the fur changes pixels near it alone: not with maps of shadows, fins, guard hairs, sorted
/// fragments or an overlay.
bool changes_stay_near(const FurFrame& frame);
/// Whether both have the same light but for curves and the fields.
bool same_light(const FurFrame& a, const FurFrame& b);
/// Whether light is made a picture the same way.
bool same_finish(const FurFrame& a, const FurFrame& b);

/// Targets that are drawn into, and what they show. Targets have `pixels()`.
template <class Targets>
struct CachedView : Targets {
  std::optional<ShownFrame> shown;  // none: the targets are to be used again
  bool came_back = false;           // asked for more than once
};

/// So that several who groom, or look from several sides, do not cost each other whole frames.
template <class Targets>
class ViewCache {
 public:
  using View = CachedView<Targets>;

  /// The view that shows the frame's light: this frame but for curves and changes of the model's fields. Its picture is
  /// lost where it is of another format, or finished otherwise. If there is none, targets that may be drawn over.
  View take(const FurFrame& frame, int format);
  /// Frames whose changes do not stay near are not kept, their targets are. What is too many or too large is given
  /// back: first what shows nothing, then what was asked for once, as an orbit asks for each of its frames, then what
  /// is oldest.
  void keep(View view);
  void clear_shown() {
    for (View& view : views_) view.shown.reset();
  }
  void give_back() { views_.clear(); }

 private:
  static constexpr std::size_t max_views = 4;
  static constexpr std::int64_t max_pixels = 2048 * 2048;  // of all views together

  using Views = std::list<View>;  // the last one first
  typename Views::iterator victim();
  View take_out(typename Views::iterator view) {
    View taken = std::move(*view);
    views_.erase(view);
    return taken;
  }

  Views views_;
};

/// The part of the picture where curves are not, or do not look, the same in both frames.
std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip);

/// The pixels that the box touches; no pixels for no box.
Area area_of(const std::optional<ClipBox>& box, int width, int height);
/// All cells that an area of a picture of that size touches.
CellBox cells_of(const Area& area, int width, int height);

/// The pixels of a finished picture that an area of its light touches.
Area finished_area(const Area& area, glm::ivec2 light, glm::ivec2 picture);

template <class Targets>
CachedView<Targets> ViewCache<Targets>::take(const FurFrame& frame, int format) {
  const auto shows = [&](const View& view) {
    return view.shown && changes_stay_near(frame) && same_light(view.shown->frame, frame);
  };
  const auto found = std::find_if(views_.begin(), views_.end(), shows);
  if (found == views_.end()) {
    const bool spare = std::any_of(views_.begin(), views_.end(), [](const View& view) { return !view.shown; });
    if (!spare && views_.size() < max_views) return {};
    View view = take_out(victim());
    view.shown.reset(), view.came_back = false;
    return view;
  }
  View view = take_out(found);
  if (view.shown->format != format || !same_finish(view.shown->frame, frame)) view.shown->format = 0;
  view.came_back = true;
  return view;
}

template <class Targets>
void ViewCache<Targets>::keep(View view) {
  if (view.shown && !changes_stay_near(view.shown->frame)) view.shown.reset();
  if (view.pixels() > max_pixels) return;
  views_.push_front(std::move(view));
  std::int64_t pixels = 0;
  for (const View& each : views_) pixels += each.pixels();
  while (views_.size() > max_views || pixels > max_pixels) pixels -= take_out(victim()).pixels();
}

// The last view is kept: two that are asked for in turn would push each other out before they come back.
template <class Targets>
typename ViewCache<Targets>::Views::iterator ViewCache<Targets>::victim() {
  assert(!views_.empty());
  const auto oldest = [&](auto first, auto unwanted) {
    const auto found = std::find_if(views_.rbegin(), std::make_reverse_iterator(first), unwanted);
    return found == std::make_reverse_iterator(first) ? views_.end() : std::prev(found.base());
  };
  const auto spare = oldest(views_.begin(), [](const View& view) { return !view.shown; });
  if (spare != views_.end()) return spare;
  const auto once = oldest(std::next(views_.begin()), [](const View& view) { return !view.came_back; });
  return once != views_.end() ? once : std::prev(views_.end());
}

}  // namespace pelage
