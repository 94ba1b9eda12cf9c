// A frame's light, drawn in pieces where others may be served in between.
#include <utility>

#include "renderer/frame/gl_renderer.h"
#include "renderer/frame/parts.h"
#include "renderer/frame/pieces.h"
#include "renderer/frame/run_beside.h"
#include "renderer/gl/sync.h"

namespace pelage {

namespace {

/// What a software GL takes for a fragment.
double fragment_ms(FragmentOrder order) {
  constexpr double sorted = 1e-3, ordered = 1e-4;
  return order == FragmentOrder::sorted ? sorted : ordered;
}

}  // namespace

Area area_of(const RenderTarget& target) { return {0, 0, target.width(), target.height()}; }

void add_counts(FrameCounters& total, const FrameCounters& more) {
  total.passes += more.passes, total.draws += more.draws, total.textures += more.textures;
  total.bytes += more.bytes, total.fragments += more.fragments;
  total.objects += more.objects, total.allocated += more.allocated;
}

void add_times(DrawTimes& total, const DrawTimes& more) {
  total.shadow += more.shadow, total.draw += more.draw, total.read += more.read, total.cpu += more.cpu;
  add_counts(total.counters, more.counters);
}

Result<GlRenderer::Prepared> GlRenderer::draw_part(const FurFrame& frame, const std::optional<Area>& part,
                                                   DrawTimes& times) {
  const DrawClock clock(times);
  fragments_.begin();
  const Prepared scene = prepare_scene(frame, part, times);
  const Status drawn = draw_light(frame, scene);
  fragments_.end();
  if (!drawn.ok()) return drawn;
  if (const Status answer = wait_for(gl_); !answer.ok()) return answer;
  add_counts(times.counters, take_counters());
  return scene;
}

Result<GlRenderer::Prepared> GlRenderer::draw_in_pieces(const FurFrame& frame, const std::optional<ShownFrame>& shown,
                                                        const Pause& pause, DrawTimes& times) {
  const Status given_up = failure(Code::conflict, "the drawing was given up");
  if (pause && !bake(frame.coat, pause)) return given_up;
  const std::optional<Area> part = shown ? std::optional(changed_area(frame, *shown)) : std::nullopt;
  if (!pause) return draw_part(frame, part, times);
  Pieces pieces = pieces_of(frame, part.value_or(area_of(view_.drawn)));
  Area piece = pieces.next();
  if (pieces.done()) return draw_part(frame, part, times);
  if (!let_in(pause) || !bake(frame.coat, pause)) return given_up;  // large targets take long to make
  prepare_alone(frame, part, times);                                // shadow maps, which the pieces share
  for (;; piece = pieces.next()) {
    if (!let_in(pause) || !bake(frame.coat, pause)) return given_up;  // many coats may have passed
    const Stopwatch passed;
    if (const Result<Prepared> drawn = draw_part(frame, piece, times); !drawn) return drawn.status();
    if (pieces.done()) break;
    pieces.took(passed.milliseconds());
  }
  return prepare_alone(frame, part, times);  // for what is drawn beside light
}

GlRenderer::Prepared GlRenderer::prepare_alone(const FurFrame& frame, const std::optional<Area>& part,
                                               DrawTimes& times) {
  const DrawClock clock(times);
  return prepare_scene(frame, part, times);
}

bool GlRenderer::bake(const Coat& coat, const Pause& pause) {
  if (has(coat)) return true;
  const auto next = [&] { return let_in(pause); };
  std::optional<Slices> slices = run_beside(next, [&](const auto& go_on) { return bake_slices(coat, go_on); });
  if (slices && !has(coat)) add(coat, std::move(*slices));
  return slices.has_value();
}

Pieces GlRenderer::pieces_of(const FurFrame& frame, const Area& area) {
  const int width = view_.drawn.width(), height = view_.drawn.height();
  const FurWork fur = models_.at(frame.model).work_of(shell_view(frame, block_of(frame), area), {width, height});
  const glm::dvec2 pixels(width, height);
  const auto work = [fur, pixels](const Area& in) {
    const glm::dvec2 low(in.left, pixels.y - in.top - in.height), size(in.width, in.height);
    return in.pixels() + fur.in(low / pixels, (low + size) / pixels);
  };
  return {area, work, fragment_ms(frame.knobs.order)};
}

bool GlRenderer::let_in(const Pause& pause) {
  CachedView<Targets> view = std::move(view_);
  const bool go_on = pause();
  view_ = go_on ? std::move(view) : CachedView<Targets>();
  return go_on;
}

}  // namespace pelage
