// Frames without a GL: fur marched on the CPU, finished there, and kept so that a stroke draws its part alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/base/status.h"
#include "renderer/frame/draw_times.h"
#include "renderer/frame/pieces.h"
#include "renderer/frame/view_cache.h"
#include "renderer/image/image.h"
#include "renderer/marched/marcher.h"

namespace pelage {

/// How closely knobs ask for fur to be marched: `shells` boundaries, up to 64, fewer inside where the policy is
/// adaptive, and `shells` times `steps` samples of the coat, up to 1024.
MarchQuality march_quality(const Knobs& knobs);

/// Belongs to one thread.
class MarchedRenderer {
 public:
  explicit MarchedRenderer(int threads) : marcher_(threads), threads_(threads) {}

  /// What it draws with: "AVX2 on the CPU".
  static std::string description();
  /// Whether it draws all that a frame shows: not maps of shadows but for penumbras, guard hairs and
  /// overlays.
  static bool draws(const FurFrame& frame);

  // As Renderer has them.
  void add(const FurModel& model, const FurFields& fields) { marcher_.add(model, fields); }
  void update(std::uint64_t model, const FurFields& fields) { marcher_.update(model, fields); }
  Result<Image> draw(const FurFrame& frame, DrawTimes* times, const Pause& pause);
  Result<Image16> draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause);
  /// Premultiplied linear light with the ground's shadow in alpha: what beauty and alpha of the AOVs are.
  Result<FloatImage> draw_beauty(const FurFrame& frame, DrawTimes* times, const Pause& pause);
  void clear_view_cache() { views_.clear_shown(); }
  std::size_t bytes_of(std::uint64_t original) const { return marcher_.bytes_of(original); }
  void forget(std::uint64_t original) { marcher_.forget(original); }
  void forget_all();

 private:
  using View = CachedView;

  /// Draws the light of what changed since the view was shown, or all of it, into the view. The area that was
  /// drawn; none when the pause gave it up.
  std::optional<Area> draw_light(const FurFrame& frame, const std::optional<ShownFrame>& shown, const Pause& pause,
                                 DrawTimes& times, View& view);
  Area changed_area(const FurFrame& frame, const ShownFrame& shown, const View& view) const;
  bool bake(const Coat& coat, const Pause& pause);
  /// Makes the view's light of the frame's size; false where there is no memory for it.
  bool fit(const FurFrame& frame, View& view);
  /// Draws the light and makes a picture of it: `finish` takes the view and the area that was drawn.
  template <class Picture, class Finish>
  Result<Picture> draw_finished(const FurFrame& frame, int format, DrawTimes* times, const Pause& pause,
                                const Finish& finish);

  Marcher marcher_;
  int threads_;
  ViewCache views_;
};

}  // namespace pelage
