// Measures what table 1 of GPU fur does: five models of the same sizes, 16 shells, one light, maps of 512 x 512,
// without and with shadows. The paper's figures were taken on a GeForce FX 5700 Ultra; it does not state the size of
// the picture.
// usage: bench_table1 [--repetitions N] [--size PIXELS]
#include <algorithm>
#include <cstdio>

#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

struct PaperRow {
  double shell_maps, depth_maps, plain, shadowed;  // ms, ms, frames a second, frames a second
};

struct Row {
  const char* name;
  BuiltinModel model;
  bool pattern;
  PaperRow paper;
};

constexpr Row rows[] = {{"torus", {Builtin::torus, 567}, false, {80, 15, 65.3, 38.7}},
                        {"creature", {Builtin::creature, 5000}, false, {100, 20, 16.7, 10.5}},
                        {"knot", {Builtin::knot, 2880}, false, {100, 15, 20, 12}},
                        {"cloth", {Builtin::cloth, 1401}, false, {90, 15, 33.4, 20}},
                        {"zebra", {Builtin::creature, 6010}, true, {110, 15, 14.3, 9.2}}};

testing::FurredModel model_of(const Row& row) {
  testing::FurredModel model = testing::furred(row.model);
  if (row.pattern) model.settings.coats[0].coat.pattern.kind = PatternKind::stripes;
  model.settings.lights.resize(1);
  return model;
}

/// Milliseconds that drawing a light's maps adds to a frame: the difference of the minima with new and with cached
/// maps.
double making(Renderer& renderer, FurFrame frame, bool shell_maps, CastShadow cast, int repetitions) {
  double min = 1e300;
  frame.lights[0].self_shadow_maps = shell_maps, frame.lights[0].cast_shadow = cast;
  double min_cached = min;
  for (int i = 0; i <= repetitions; ++i) {
    frame.lights[0].radiance *= 1.0001f;  // any change of a light invalidates its maps
    DrawTimes anew, cached;
    draw(renderer, frame, &anew), draw(renderer, frame, &cached);
    if (i > 0) min = std::min(min, anew.draw), min_cached = std::min(min_cached, cached.draw);
  }
  return min - min_cached;
}

void run(Renderer& renderer, const Row& row, int size, int repetitions) {
  const testing::FurredModel model = model_of(row);
  FrameRequest request = testing::small_frame(AutoView::three_quarter, size);
  request.knobs.method = Method::shells;
  request.knobs.shells.self_shadow = false;
  testing::draw(renderer, model, request);
  const FurFrame plain = make_frame(model.view(), request);
  FurFrame cached = plain;
  cached.knobs.shells.self_shadow = cached.knobs.shells.shadow_maps = true;
  const double depth = making(renderer, cached, false, CastShadow::soft, repetitions);
  const double both = making(renderer, cached, true, CastShadow::soft, repetitions);
  cached.lights[0].self_shadow_maps = true, cached.lights[0].cast_shadow = CastShadow::soft;
  FurFrame anew = cached;
  const std::vector<Cost> costs = measure_alternating({[&] { draw(renderer, plain); }, [&] { draw(renderer, cached); },
                                                       [&] {
                                                         anew.lights[0].radiance *= 1.0001f;
                                                         draw(renderer, anew);
                                                         draw(renderer, cached);
                                                       }},
                                                      repetitions);
  // The third work draws two frames, each with new maps: half of its time is one frame.
  const double frame_anew = costs[2].wall / 2;
  std::printf(
      "| %s, %zu | %.0f (%.0f) | %.0f (%.0f) | %.1f, %.1f/s (%.1f) | %.1f, %.1f/s (%.1f) | %.2f (%.2f) | %.1f, %.1f/s "
      "|\n",
      row.name, model.model.surface.mesh().triangles.size(), both - depth, row.paper.shell_maps, depth,
      row.paper.depth_maps, costs[0].wall, 1e3 / costs[0].wall, row.paper.plain, costs[1].wall, 1e3 / costs[1].wall,
      row.paper.shadowed, costs[1].cpu / costs[0].cpu, row.paper.plain / row.paper.shadowed, frame_anew,
      1e3 / frame_anew);
  std::fflush(stdout);
  renderer.forget(model.model.id);
}

int main(int count, char** arguments) {
  const int repetitions = argument(count, arguments, "--repetitions", 7),
            size = argument(count, arguments, "--size", 512);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  std::printf("%d x %d pixels, minimum of %d; the paper's figures in brackets\n\n", size, size, repetitions);
  std::printf(
      "| model, triangles | shell maps, ms | depth and width maps, ms | frame without shadow, ms | with cached maps, "
      "ms "
      "| "
      "ratio | with new maps |\n|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows) run(*opened.renderer, row, size, repetitions);
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
