// A frame's light, drawn in pieces where others may be served in between.
#include <utility>

#include "renderer/frame/parts.h"
#include "renderer/frame/pieces.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/wait.h"

namespace pelage {

namespace {

/// The pieces of an area, by what a fast software GL takes: a small frame is one piece.
Pieces pieces_of(const FurFrame& frame, const Area& area) {
  constexpr double sorted_ms = 1e-3, ordered_ms = 1e-4;  // of a fragment
  return {area, static_cast<double>(frame.knobs.shells),
          frame.knobs.order == FragmentOrder::sorted ? sorted_ms : ordered_ms};
}

}  // namespace

Area area_of(const RenderTarget& target) { return {0, 0, target.width(), target.height()}; }

void add_counts(FrameCounters& total, const FrameCounters& more) {
  total.passes += more.passes, total.draws += more.draws, total.textures += more.textures;
  total.bytes += more.bytes, total.fragments += more.fragments;
  total.objects += more.objects, total.allocated += more.allocated;
}

Result<Renderer::Prepared> Renderer::draw_part(const FurFrame& frame, const std::optional<Area>& part,
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

Result<Renderer::Prepared> Renderer::draw_in_pieces(const FurFrame& frame, const std::optional<ShownFrame>& shown,
                                                    const Pause& pause, DrawTimes& times) {
  const std::optional<Area> part = shown ? std::optional(changed_area(frame, *shown)) : std::nullopt;
  Pieces pieces = pieces_of(frame, part.value_or(area_of(view_.drawn)));
  Area piece = pieces.next();
  if (!pause || pieces.done()) return draw_part(frame, part, times);
  prepare_alone(frame, part, times);  // shadow maps, which the pieces share
  for (;; piece = pieces.next()) {
    if (!let_in(pause)) return failure(Code::conflict, "the drawing was given up");
    const Stopwatch passed;
    const auto before = times.counters.fragments;
    if (const Result<Prepared> drawn = draw_part(frame, piece, times); !drawn) return drawn.status();
    if (pieces.done()) break;
    pieces.took(passed.milliseconds(), static_cast<double>(times.counters.fragments - before));
  }
  return prepare_alone(frame, part, times);  // for what is drawn beside light
}

Renderer::Prepared Renderer::prepare_alone(const FurFrame& frame, const std::optional<Area>& part, DrawTimes& times) {
  const DrawClock clock(times);
  return prepare_scene(frame, part, times);
}

bool Renderer::let_in(const Pause& pause) {
  CachedView view = std::move(view_);
  const bool go_on = pause();
  view_ = go_on ? std::move(view) : CachedView();
  return go_on;
}

}  // namespace pelage
