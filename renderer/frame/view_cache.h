// The last views that were drawn on the CPU. A stroke changes a part of the body: when a view is drawn again, the same
// but for the fields of some vertices and what stands on them, only the part of the picture that these may reach is
// drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>

#include "renderer/finish/finish.h"
#include "renderer/frame/areas.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

struct ShownFrame {
  FurFrame frame;
  int format = 0;             // of the finished picture, 0 where it is not this frame's
  std::uint64_t changes = 0;  // of the model when it was drawn, as its drawer counts them
};

/// A picture that was drawn, to be drawn into again.
struct CachedView {
  FloatImage light;
  Image picture;                    // finished, of 8 bits
  std::optional<ShownFrame> shown;  // that it shows; none: it is to be used again
  bool came_back = false;           // asked for more than once

  std::int64_t pixels() const { return light.width * static_cast<std::int64_t>(light.height); }
};

/// The views that were drawn last, kept so that several clients who groom, or look from several sides, do not cost each
/// other whole frames.
class ViewCache {
 public:
  /// The view that shows the frame's light: this frame but for changes of the model's fields. Its picture is lost where
  /// it is of another format, or finished otherwise. If there is none, one that may be drawn over.
  CachedView take(const FurFrame& frame, int format);
  /// Keeps a view, and evicts views that are too many or too large: first those that show nothing, then those that were
  /// requested once, as an orbit requests each of its frames, then the oldest.
  void keep(CachedView view);
  void clear_shown() {
    for (CachedView& view : views_) view.shown.reset();
  }
  void give_back() { views_.clear(); }

 private:
  static constexpr std::size_t max_views = 4;
  static constexpr std::int64_t max_pixels = 2048 * 2048;  // of all views together

  using Views = std::list<CachedView>;  // the last one first
  Views::iterator victim();
  CachedView take_out(Views::iterator view);

  Views views_;
};

/// Finishes a view's light as a picture of 8 bits. If the view has that picture already, only the area `changed`, whose
/// light is new, is finished again; a picture under an overlay is not stored. The input's light is the view's own, or
/// that with the ground.
Image finish_view(const FurFrame& frame, const FinishInput& input, const Area& changed, CachedView& view);
/// ShownFrame::format of such a picture.
int kept_format(const FurFrame& frame);

}  // namespace pelage
