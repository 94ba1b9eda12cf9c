// The dial on models that no calibration knows: budgets and errors that are kept, and what the choices cost against a
// full sweep. With --sweep the candidates of a ladder on the calibration's own scenes.
// usage: bench_dial [--size PIXELS] [--truth SHELLS] [--scenes N]
#include <cstdio>

#include "server/calibration/ladder.h"
#include "server/calibration/measure.h"
#include "server/scene/fur_view.h"
#include "server/surface/builtin.h"
#include "server/surface/prepare.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

int main(int count, char** arguments) {
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  const std::vector<Knobs> ladder = candidate_ladder();
  const int scenes = argument(count, arguments, "--scenes", 100);
  const MeasureOptions options{argument(count, arguments, "--truth", 256), argument(count, arguments, "--repetitions", 1)};
  std::uint64_t id = 0;
  std::printf("%zu rows\n", ladder.size());
  for (const CalibrationScene& described : calibration_scenes()) {
    if (static_cast<int>(id) >= scenes) break;
    Result<Mesh> mesh = prepare(make_builtin(described.builtin), Axis::plus_y, Axis::plus_z, false);
    MeasuredScene scene = make_measured_scene(std::move(*mesh), described.fur, ++id);
    scene.settings.coat = described.coat, scene.settings.look.shading = described.shading;
    sync_scene(*opened.renderer, scene.view(), {});
    for (const CalibrationScene::View& view : described.views) {
      const FurFrame frame = measured_frame(scene.view(), view);
      Result<MeasuredView> measured = failure(Code::internal, "");
      const Cost cost = measure([&] { measured = measure_view(*opened.renderer, cost_unit(true, 0), scene.view(), frame, ladder, options); });
      if (!measured) return std::printf("%s\n", measured.status().message.c_str()), 1;
      const ViewFeatures& f = measured->features;
      std::printf("scene %d size %d wall %.1f s cpu %.1f s: area %.0f covered %.0f edges %.0f visible %.0f of %.0f behind %.2f fur %.1f strand %.2f bend %.2f light %.2f\n", int(id), view.size,
                  cost.wall / 1e3, cost.cpu / 1e3, f.area, f.covered, f.edges, f.visible, f.triangles, f.behind, f.fur_pixels, f.strand_pixels, f.bending, f.lightness);
      for (std::size_t i = 0; i < ladder.size(); ++i)
        std::printf("  %-6s %4d x %2d, scale %.2f %s: %8.2f ms %.4f\n", ladder[i].order == FragmentOrder::sorted ? "sorted" : "layers",
                    ladder[i].shells, ladder[i].steps, ladder[i].scale, ladder[i].accumulation == Accumulation::full ? "full" : "half", measured->cost_ms[i], measured->error[i]);
      std::fflush(stdout);
    }
    opened.renderer->forget(scene.model.id);
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
