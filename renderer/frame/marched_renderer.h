// Frames without a GL: fur marched on the CPU, finished there, and kept so that a stroke draws its part alone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "protocol/base/status.h"
#include "renderer/coat/slices.h"
#include "renderer/frame/draw_times.h"
#include "renderer/frame/marched_aovs.h"
#include "renderer/frame/pieces.h"
#include "renderer/frame/view_cache.h"
#include "renderer/image/image.h"
#include "renderer/marched/marcher.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// How closely knobs ask for fur to be marched: `shells` boundaries, up to 64, fewer inside where the policy is
/// adaptive, and `shells` times `steps` samples of the coat, up to 1024.
MarchQuality march_quality(const Knobs& knobs);

/// Belongs to one thread.
class MarchedRenderer {
 public:
  explicit MarchedRenderer(int threads, CoatSource coats = bake_here)
      : marcher_(threads), coats_(std::move(coats)), threads_(threads) {}

  /// What it draws with: "AVX2 on the CPU".
  static std::string description();

  bool has(std::uint64_t model) const { return marcher_.has(model); }
  // As Renderer has them.
  UploadCount add(const FurModel& model, const FurFields& fields) { return taken({marcher_.add(model, fields), 1}); }
  UploadCount update(std::uint64_t model, const FurFields& fields) {
    return taken({marcher_.update(model, fields), 0});
  }
  Result<Image> draw(const FurFrame& frame, DrawTimes* times, const Pause& pause);
  Result<Image16> draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause);
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes* times,
                                            const Pause& pause);
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes* times);
  /// FurFrame::overlay, which is a field or a map of a light: sRGB with straight alpha. Refused (invalid) where no
  /// light of the frame has such a map.
  Result<FloatImage> overlay(const FurFrame& frame) const;
  /// The same of what is the shape of the model.
  Result<FloatImage> shape_overlay(const FurFrame& frame) const;
  void clear_view_cache() { views_.clear_shown(); }
  std::optional<CoatNeed> missing_coat(const FurFrame& frame) const { return marcher_.missing_coat(frame); }
  std::size_t coat_bytes() const { return marcher_.coat_bytes(); }
  std::size_t bytes_of(std::uint64_t original) const { return marcher_.bytes_of(original); }
  void forget(std::uint64_t original) { marcher_.forget(original); }
  void forget_all();

 private:
  using View = CachedView;

  /// Draws the light of what changed since the view was shown, or all of it, into the view. The area that was
  /// drawn; none when the pause gave it up.
  std::optional<Area> draw_changed(const FurFrame& frame, const std::optional<ShownFrame>& shown, const Pause& pause,
                                   DrawTimes& times, View& view);
  /// Draws an area in pieces where there is a pause; whether it was not given up.
  bool draw_area(const FurFrame& frame, const Area& area, const Pause& pause, DrawTimes& times, FloatImage& light,
                 std::vector<AovPixel>* aovs);
  /// Light and what AOVs keep of the whole frame.
  Result<MarchedAovs> draw_kept(const FurFrame& frame, DrawTimes& times, const Pause& pause);
  /// What lies over the frame's picture; empty for nothing.
  Result<FloatImage> draw_overlay(const FurFrame& frame, const Pause& pause, DrawTimes& times);
  Area changed_area(const FurFrame& frame, const ShownFrame& shown, const View& view) const;
  /// Gets what the frame reads of its coat; false where the pause gave it up.
  bool bake(const FurFrame& frame, const Pause& pause);
  /// Draws the light and makes a picture of it: `finish` takes the view, the overlay (null for none) and the area that
  /// was drawn.
  template <class Picture, class Finish>
  Result<Picture> draw_finished(const FurFrame& frame, int format, DrawTimes* times, const Pause& pause,
                                const Finish& finish);

  /// Counts bytes for the next frame's counters.
  UploadCount taken(UploadCount count) {
    taken_bytes_ += count.bytes;
    return count;
  }

  Marcher marcher_;
  CoatSource coats_;
  std::size_t taken_bytes_ = 0;  // since the last frame
  int threads_;
  ViewCache views_;
};

}  // namespace pelage
