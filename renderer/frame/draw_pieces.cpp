// A frame's light, drawn in pieces where others may be served in between.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "renderer/frame/areas.h"
#include "renderer/frame/gl_renderer.h"
#include "renderer/frame/parts.h"
#include "renderer/frame/pieces.h"
#include "renderer/gl/sync.h"

namespace pelage {

namespace {

/// What a software GL takes for a fragment.
double fragment_ms(FragmentOrder order) {
  constexpr double sorted = 1e-3, ordered = 1e-4;
  return order == FragmentOrder::sorted ? sorted : ordered;
}

/// All that hold one of the pixels, and one more on each side.
glm::ivec2 cells_in(glm::ivec2 range, int pixels) {
  const auto cell = [&](int pixel) { return static_cast<int>(std::int64_t{pixel} * cells_a_side / pixels); };
  return {std::max(0, cell(range.x) - 1), std::min(cells_a_side - 1, cell(range.y) + 1)};
}

}  // namespace

Area area_of(const RenderTarget& target) { return {0, 0, target.width(), target.height()}; }

CellBox cells_of(const Area& area, int width, int height) {
  const int low = height - area.top - area.height;
  const glm::ivec2 columns = cells_in({area.left, area.left + area.width}, width);
  const glm::ivec2 rows = cells_in({low, low + area.height}, height);
  return {columns.x, rows.x, columns.y, rows.y};
}

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

Result<GlRenderer::Prepared> GlRenderer::draw_in_pieces(const FurFrame& frame, const Pause& pause, DrawTimes& times) {
  if (!pause) return draw_whole(frame, times);
  const Status given_up = failure(Code::conflict, "the drawing was given up");
  if (!bake(frame.coat, pause)) return given_up;
  Pieces pieces = pieces_of(frame);
  Area piece = pieces.next();
  if (pieces.done()) return draw_whole(frame, times);
  if (!let_in(pause) || !bake(frame.coat, pause)) return given_up;  // large targets take long to make
  prepare_whole(frame, times);                                      // shadow maps, which the pieces share
  for (;; piece = pieces.next()) {
    if (!let_in(pause) || !bake(frame.coat, pause)) return given_up;  // many coats may have passed
    const Stopwatch passed;
    if (const Result<Prepared> drawn = draw_part(frame, piece, times); !drawn) return drawn.status();
    if (pieces.done()) break;
    pieces.took(passed.milliseconds());
  }
  return prepare_whole(frame, times);  // for what is drawn beside light
}

Result<GlRenderer::Prepared> GlRenderer::draw_whole(const FurFrame& frame, DrawTimes& times) {
  if (!frame.crop) return draw_part(frame, {}, times);
  prepare_whole(frame, times);  // what is outside the crop casts shadows into it
  return draw_part(frame, drawn_area(frame, {targets_.drawn.width(), targets_.drawn.height()}), times);
}

GlRenderer::Prepared GlRenderer::prepare_whole(const FurFrame& frame, DrawTimes& times) {
  const DrawClock clock(times);
  return prepare_scene(frame, {}, times);
}

bool GlRenderer::bake(const Coat& coat, const Pause& pause) {
  if (has(coat)) return true;
  const std::shared_ptr<const Slices> slices = coat_source_({coat}, [&] { return let_in(pause); });
  if (slices && !has(coat)) add(coat, *slices);
  return slices != nullptr;
}

Pieces GlRenderer::pieces_of(const FurFrame& frame) {
  const int width = targets_.drawn.width(), height = targets_.drawn.height();
  const FurWork fur = models_.at(frame.model).work_of(shell_view(frame, block_of(frame), {}), {width, height});
  const glm::dvec2 pixels(width, height);
  const auto work = [fur, pixels](const Area& in) {
    const glm::dvec2 low(in.left, pixels.y - in.top - in.height), size(in.width, in.height);
    return in.pixels() + fur.in(low / pixels, (low + size) / pixels);
  };
  return {drawn_area(frame, {width, height}), work, fragment_ms(frame.knobs.order)};
}

bool GlRenderer::let_in(const Pause& pause) {
  Targets drawn_so_far = std::exchange(targets_, {});  // others draw into targets of their own
  const bool go_on = pause();
  targets_ = go_on ? std::move(drawn_so_far) : Targets();
  return go_on;
}

}  // namespace pelage
