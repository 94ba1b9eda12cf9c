// Caches the last views that were drawn on the CPU. If a view is drawn again and only fields of some vertices have
// changed, as after a stroke, only the part of the picture that they can affect is drawn.
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

/// The frame that a cached view shows.
struct ShownFrame {
  FurFrame frame;
  int format = 0;             // cached_format of the finished picture, 0 if that is not of this frame
  std::uint64_t changes = 0;  // Raster::version when it was drawn
};

/// A view that was drawn, with its buffers for the next drawing.
struct CachedView {
  FloatImage light;
  Image picture;                    // finished, 8 bits
  std::optional<ShownFrame> shown;  // what it shows; none if only its buffers are of use
  bool requested_again = false;     // it was requested more than once

  std::int64_t pixels() const { return light.width * static_cast<std::int64_t>(light.height); }
};

/// Caches several views, so that clients who groom at the same time, or from several sides, do not make each other's
/// frames be drawn as a whole.
class ViewCache {
 public:
  /// Takes out the view that shows the frame's light, up to changes of the model's fields. Its finished picture counts
  /// as lost if it has another format or was finished differently. If there is no such view, returns one without
  /// `shown`.
  CachedView take(const FurFrame& frame, int format);
  /// Puts a view into the cache, and evicts views while there are too many or they are too large: first those that show
  /// nothing, then those that were requested once, as each frame of an orbit is, then the oldest.
  void keep(CachedView view);
  void invalidate() {
    for (CachedView& view : views_) view.shown.reset();
  }
  void clear() { views_.clear(); }

 private:
  static constexpr std::size_t max_views = 4;
  static constexpr std::int64_t max_pixels = 2048 * 2048;  // over all views

  using Views = std::list<CachedView>;  // most recently used first
  /// Returns the view to evict.
  Views::iterator victim();
  CachedView take_out(Views::iterator view);

  Views views_;
};

/// Finishes a view's light as a picture of 8 bits. If the view has that picture already, only the area `changed`, whose
/// light is new, is finished again. A picture with an overlay is not stored. The input's light is the view's own, or
/// that with the ground darkened.
Image finish_view(const FurFrame& frame, const FinishInput& input, const Area& changed, CachedView& view);
/// Returns ShownFrame::format for a frame: the bits of its finished picture, or 0 if an overlay keeps that from being
/// stored.
int cached_format(const FurFrame& frame);

}  // namespace pelage
