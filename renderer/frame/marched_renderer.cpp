#include "renderer/frame/marched_renderer.h"

#include <algorithm>
#include <new>
#include <utility>

#include "protocol/base/stopwatch.h"
#include "renderer/finish/finish.h"
#include "renderer/finish/resize.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/frame/run_beside.h"
#include "renderer/marched/kernels.h"
#include "renderer/marched/shadow_cache.h"

namespace pelage {

namespace {

constexpr int no_format = 0, kept_format = 8;  // bits of the finished picture's channels that is kept (ShownFrame)

/// What a sample of a pixel takes until it was measured.
constexpr double sample_ms = 1e-5;

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

bool MarchedRenderer::draws(const FurFrame& frame) {
  const Knobs& knobs = frame.knobs;
  return knobs.guard_hairs == 0 && ShadowCache::makes_all(frame) && frame.overlay == Overlay::none;
}

void MarchedRenderer::forget_all() {
  marcher_.forget_all();
  views_.give_back();
}

bool MarchedRenderer::fit(const FurFrame& frame, View& view) {
  const glm::ivec2 size = Marcher::size_of(frame);
  const auto numbers = 4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  try {
    view.light.rgba.resize(numbers);
  } catch (const std::bad_alloc&) {
    return false;
  }
  view.light.width = size.x, view.light.height = size.y;
  return true;
}

Area MarchedRenderer::changed_area(const FurFrame& frame, const ShownFrame& shown, const View& view) const {
  const glm::mat4 to_clip = world_to_clip(frame);
  std::optional<ClipBox> changed = marcher_.changed_box(frame, to_clip, shown.changes);
  if (const std::optional<ClipBox> curves = changed_curves(shown.frame, frame, to_clip))
    changed = union_of(changed, *curves);
  return area_of(changed, view.light.width, view.light.height);
}

bool MarchedRenderer::bake(const Coat& coat, const Pause& pause) {
  if (marcher_.has(coat)) return true;
  if (!pause) return marcher_.add(coat, bake_slices(coat)), true;
  std::optional<Slices> slices = run_beside(pause, [&](const auto& go_on) { return bake_slices(coat, go_on); });
  if (slices && !marcher_.has(coat)) marcher_.add(coat, std::move(*slices));
  return slices.has_value();
}

std::optional<Area> MarchedRenderer::draw_light(const FurFrame& frame, const std::optional<ShownFrame>& shown,
                                                const Pause& pause, DrawTimes& times, View& view) {
  if (!bake(frame.coat, pause)) return {};
  const float reach = marcher_.reach_of(frame.model);
  const bool same_reach = std::exchange(view.reach, reach) == reach;
  const Area whole{0, 0, view.light.width, view.light.height};
  const Area part = shown && same_reach ? changed_area(frame, *shown, view) : whole;
  if (part.pixels() == 0) return part;
  const MarchQuality quality = march_quality(frame.knobs);
  const double unit_ms = pause ? sample_ms * quality.samples : 0;
  Pieces pieces(
      part, [](const Area& area) { return area.pixels(); }, unit_ms);
  for (;;) {
    const Area piece = pieces.next();
    const Stopwatch passed;
    {
      const DrawClock clock(times);
      marcher_.draw_part(frame, quality, box_of(piece), view.light);
    }
    if (pieces.done()) return part;
    pieces.took(passed.milliseconds());
    if (!pause() || !bake(frame.coat, pause)) return {};  // many coats may have passed
  }
}

template <class Picture, class Finish>
Result<Picture> MarchedRenderer::draw_finished(const FurFrame& frame, int format, DrawTimes* times, const Pause& pause,
                                               const Finish& finish) {
  View view = views_.take(frame, format);
  if (!fit(frame, view)) {
    views_.give_back();
    return failure(Code::too_large, "no memory for a frame of this size", "/width");
  }
  DrawTimes taken;
  const std::optional<ShownFrame> shown = std::exchange(view.shown, {});
  const std::optional<Area> drawn = draw_light(frame, shown, pause, taken, view);
  if (!drawn) return failure(Code::conflict, "the drawing was given up");
  taken.counters.redrawn = drawn->pixels() / static_cast<double>(view.pixels());
  view.shown = {frame, shown ? shown->format : 0, marcher_.changes(frame.model)};
  Picture picture;
  {
    const DrawClock clock(taken);
    picture = finish(view, *drawn);
  }
  views_.keep(std::move(view));
  if (times) *times = taken;
  return picture;
}

Result<Image> MarchedRenderer::draw(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return draw_finished<Image>(frame, kept_format, times, pause, [&](View& view, const Area& drawn) {
    if (view.shown->format == kept_format) {
      const Area finished = finished_area(drawn, {view.light.width, view.light.height}, {frame.width, frame.height});
      finish_rows(frame, view.light, finished.top, finished.top + finished.height, view.picture, threads_);
    } else {
      view.picture = finish_picture(frame, view.light, threads_);
    }
    view.shown->format = kept_format;
    return view.picture;
  });
}

Result<Image16> MarchedRenderer::draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return draw_finished<Image16>(frame, no_format, times, pause, [&](View& view, const Area&) {
    return finish_picture_deep(frame, view.light, threads_);
  });
}

Result<FloatImage> MarchedRenderer::draw_beauty(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return draw_finished<FloatImage>(frame, no_format, times, pause, [&](View& view, const Area&) {
    return resized_light(view.light, frame.width, frame.height, threads_);
  });
}

}  // namespace pelage
