// What self-shadow costs: maps that are kept, the estimate that needs none, and making the maps.
// usage: bench_shadows [--repetitions N] [--size PIXELS]
#include <algorithm>
#include <cstdio>

#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

void run(Renderer& renderer, const char* name, testing::FurredModel model, std::size_t lights, int size,
         int repetitions) {
  model.settings.lights.resize(lights);
  for (Light& light : model.settings.lights) light.self_shadow_maps = true, light.cast_shadow = CastShadow::soft;
  FrameRequest request = testing::small_frame(AutoView::three_quarter, size);
  request.background = Background::colour;
  request.tone_map = ToneMap::filmic;
  request.knobs.shells = 16;
  testing::draw(renderer, model, request);
  const FurFrame estimate = make_frame(model.view(), request);
  FurFrame none = estimate, maps = estimate;
  none.knobs.self_shadow = false;
  maps.knobs.shadow_maps = true;
  const auto drawing = [&](const FurFrame& frame) { return [&] { draw(renderer, frame); }; };
  const std::vector<Cost> costs = measure_alternating({drawing(none), drawing(estimate), drawing(maps)}, repetitions);

  double making = 1e300;  // wall
  Cost fresh;             // a frame that makes its maps
  for (int i = 0; i < repetitions; ++i) {
    maps.lights[0].radiance *= 1.0001f;  // any change makes them anew
    DrawTimes times;
    fresh.lower_to(measure([&] { draw(renderer, maps, &times); }));
    making = std::min(making, times.shadow);
  }
  std::printf("%-9s %7zu %6zu | %8.1f | %8.1f %5.2f | %8.1f %5.2f | %8.1f %8.1f\n", name,
              model.model.surface.mesh().triangles.size(), lights, costs[0].cpu, costs[1].cpu,
              costs[1].cpu / costs[0].cpu, costs[2].cpu, costs[2].cpu / costs[0].cpu, making, fresh.cpu - costs[2].cpu);
  std::fflush(stdout);
  renderer.forget(model.model.id);
}

int main(int count, char** arguments) {
  const int repetitions = argument(count, arguments, "--repetitions", 7),
            size = argument(count, arguments, "--size", 512);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  std::printf("16 shells, %d pixels, maps of 512 x 512; CPU ms, least of %d\n", size, repetitions);
  std::printf("%-9s %7s %6s | %8s | %14s | %14s | %17s\n", "model", "tri", "lights", "none", "estimate ratio",
              "maps ratio", "making: wall CPU");
  for (const std::size_t lights : {1u, 3u}) {
    run(*opened.renderer, "torus", testing::furred({Builtin::torus, 5000}), lights, size, repetitions);
    run(*opened.renderer, "creature", testing::furred({Builtin::creature, 5000}), lights, size, repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
