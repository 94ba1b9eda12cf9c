#include "renderer/frame/marched_renderer.h"

#include <algorithm>
#include <cassert>
#include <new>
#include <utility>

#include "protocol/base/stopwatch.h"
#include "renderer/finish/finish.h"
#include "renderer/frame/areas.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/marched/kernels.h"
#include "renderer/marched/shadow_cache.h"
#include "renderer/marched/shape_overlay.h"
#include "renderer/overlay/field_picture.h"

namespace pelage {

namespace {

/// What a sample of a pixel takes until it was measured.
constexpr double sample_ms = 1e-5;

/// Makes light of a frame's size; false where there is no memory for it.
bool fit(const FurFrame& frame, FloatImage& light) {
  const glm::ivec2 size = Marcher::size_of(frame);
  try {
    light.rgba.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  } catch (const std::bad_alloc&) {
    return false;
  }
  light.width = size.x, light.height = size.y;
  return true;
}

/// Whether a change of the fur changes pixels near it alone.
bool changes_stay_near(const FurFrame& frame) { return !ShadowCache::wanted(frame) && frame.knobs.guard_hairs == 0; }

PixelBox box_of(const Area& area) { return {area.left, area.top, area.left + area.width, area.top + area.height}; }

}  // namespace

MarchQuality march_quality(const Knobs& knobs) {
  constexpr int max_shells = 64, max_samples = 1024;
  MarchQuality quality;
  quality.shells = std::min(knobs.shells, max_shells);
  quality.halvings = knobs.shell_policy == ShellPolicy::adaptive ? 1 : 0;
  quality.samples = std::min(knobs.shells * knobs.steps, max_samples);
  return quality;
}

std::string MarchedRenderer::description() { return std::string(instruction_set()) + " on the CPU"; }

void MarchedRenderer::forget_all() {
  marcher_.forget_all();
  views_.give_back();
}

Area MarchedRenderer::changed_area(const FurFrame& frame, const ShownFrame& shown, const View& view) const {
  const glm::mat4 to_clip = world_to_clip(frame);
  std::optional<ClipBox> changed = marcher_.changed_box(frame, to_clip, shown.changes);
  if (const std::optional<ClipBox> curves = changed_curves(shown.frame, frame, to_clip))
    changed = union_of(changed, *curves);
  return area_of(changed, view.light.width, view.light.height);
}

bool MarchedRenderer::bake(const FurFrame& frame, const Pause& pause) {
  const std::optional<CoatNeed> need = marcher_.missing_coat(frame);
  if (!need) return true;
  const std::shared_ptr<const Slices> slices = coats_(*need, pause);
  if (slices && marcher_.missing_coat(frame)) marcher_.add(need->coat, *slices);  // it may have come meanwhile
  return slices != nullptr;
}

std::optional<Area> MarchedRenderer::draw_changed(const FurFrame& frame, const std::optional<ShownFrame>& shown,
                                                  const Pause& pause, DrawTimes& times, View& view) {
  if (!bake(frame, pause)) return {};
  const float reach = marcher_.reach_of(frame.model);
  const bool same_reach = std::exchange(view.reach, reach) == reach;
  const Area whole = drawn_area(frame, {view.light.width, view.light.height});
  const Area part = shown && same_reach ? common_area(changed_area(frame, *shown, view), whole) : whole;
  if (part.pixels() == 0 || draw_area(frame, part, pause, times, view.light, nullptr)) return part;
  return {};
}

bool MarchedRenderer::draw_area(const FurFrame& frame, const Area& area, const Pause& pause, DrawTimes& times,
                                FloatImage& light, std::vector<AovPixel>* aovs) {
  const MarchQuality quality = march_quality(frame.knobs);
  const double unit_ms = pause ? sample_ms * quality.samples : 0;
  Pieces pieces(
      area, [](const Area& piece) { return piece.pixels(); }, unit_ms);
  for (;;) {
    const Area piece = pieces.next();
    const Stopwatch passed;
    {
      const DrawClock clock(times);
      marcher_.draw_part(frame, quality, box_of(piece), light, aovs);
    }
    if (pieces.done()) return true;
    pieces.took(passed.milliseconds());
    if (!pause() || !bake(frame, pause)) return false;  // many coats may have passed
  }
}

Result<MarchedAovs> MarchedRenderer::draw_kept(const FurFrame& frame, DrawTimes& times, const Pause& pause) {
  MarchedAovs drawn;
  if (!fit(frame, drawn.light)) return no_memory_for_frame();
  try {
    drawn.pixels.resize(drawn.light.rgba.size() / 4);
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
  const Area whole = drawn_area(frame, {drawn.light.width, drawn.light.height});
  if (!bake(frame, pause) || !draw_area(frame, whole, pause, times, drawn.light, &drawn.pixels))
    return drawing_given_up();
  return drawn;
}

Result<FloatImage> MarchedRenderer::draw_overlay(const FurFrame& frame, const Pause& pause, DrawTimes& times) {
  if (frame.overlay == Overlay::none) return FloatImage();
  if (frame.overlay != Overlay::shell_count) {
    const DrawClock clock(times);
    return overlay(frame);
  }
  const Result<MarchedAovs> drawn = draw_kept(frame, times, pause);
  if (!drawn) return drawn.status();
  return count_overlay(aov_picture(*drawn, Aov::shell_count, frame.width, frame.height, threads_), frame.knobs.shells);
}

Result<FloatImage> MarchedRenderer::overlay(const FurFrame& frame) const {
  std::optional<FloatImage> overlay = marcher_.draw_overlay(frame);
  if (overlay) return std::move(*overlay);
  return failure(Code::invalid, "no light of this frame has shadow maps and casts a shadow", "/overlay");
}

Result<FloatImage> MarchedRenderer::shape_overlay(const FurFrame& frame) const {
  if (!is_shape(frame.overlay)) return failure(Code::invalid, "Strands have no such map.", "/overlay");
  return overlay(frame);
}

template <class Picture, class Finish>
Result<Picture> MarchedRenderer::draw_finished(const FurFrame& frame, int format, DrawTimes* times, const Pause& pause,
                                               const Finish& finish) {
  View view = views_.take(frame, format);
  if (!fit(frame, view.light)) {
    views_.give_back();
    return no_memory_for_frame();
  }
  DrawTimes taken;
  const std::optional<ShownFrame> shown = std::exchange(view.shown, {});
  const std::optional<Area> drawn = draw_changed(frame, shown, pause, taken, view);
  if (!drawn) return drawing_given_up();
  taken.counters.redrawn = drawn->pixels() / static_cast<double>(view.pixels());
  taken.counters.bytes = std::exchange(taken_bytes_, 0);
  view.shown = {frame, shown ? shown->format : 0, marcher_.changes(frame.model)};
  const Result<FloatImage> overlay = draw_overlay(frame, pause, taken);
  if (!overlay) return overlay.status();
  Picture picture;
  {
    const DrawClock clock(taken);
    picture = finish(view, overlay->rgba.empty() ? nullptr : &*overlay, *drawn);
  }
  if (!changes_stay_near(frame)) view.shown.reset();
  views_.keep(std::move(view));
  if (times) *times = taken;
  return picture;
}

Result<Image> MarchedRenderer::draw(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return draw_finished<Image>(frame, kept_format(frame), times, pause,
                              [&](View& view, const FloatImage* overlay, const Area& drawn) {
                                return finish_view(frame, {view.light, overlay, threads_}, drawn, view);
                              });
}

Result<Image16> MarchedRenderer::draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return draw_finished<Image16>(frame, 0, times, pause, [&](View& view, const FloatImage* overlay, const Area&) {
    return finish_picture_deep(frame, {view.light, overlay, threads_});
  });
}

Result<std::vector<FloatImage>> MarchedRenderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                                           DrawTimes* times, const Pause& pause) {
  DrawTimes taken;
  const Result<MarchedAovs> drawn = draw_kept(frame, taken, pause);
  if (!drawn) return drawn.status();
  std::vector<FloatImage> images;
  {
    const DrawClock clock(taken);
    for (const Aov aov : aovs) images.push_back(aov_picture(*drawn, aov, frame.width, frame.height, threads_));
  }
  taken.counters.redrawn = 1;
  taken.counters.bytes = std::exchange(taken_bytes_, 0);
  if (times) *times = taken;
  return images;
}

Result<Backplate> MarchedRenderer::draw_backplate(const FurFrame& asked, DrawTimes* times) {
  DrawTimes taken;
  Backplate base;
  try {
    const DrawClock clock(taken);
    MarchedAovs drawn;
    drawn.light = marcher_.draw_bare(backplate_frame(asked), drawn.pixels);
    base = backplate_of(std::move(drawn), threads_);
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
  if (times) *times = taken;
  return base;
}

}  // namespace pelage
