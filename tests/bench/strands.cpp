// Traced strands of one coat: how long growing, the first picture and all passes take, and how the noise falls.
// usage: bench_strands [--ply FILE] [--count STRANDS] [--size PIXELS] [--passes N] [--threads N] [--paths] [--out PNG]
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "renderer/image/image.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

struct Options {
  std::string ply, out;
  int count = 9000, size = 640, passes = 48, threads = 2;
  bool paths = false;
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--paths") options.paths = true;
    else if (name == "--ply") options.ply = value, ++i;
    else if (name == "--out") options.out = value, ++i;
    else if (name == "--count") options.count = std::atoi(value), ++i;
    else if (name == "--size") options.size = std::atoi(value), ++i;
    else if (name == "--passes") options.passes = std::atoi(value), ++i;
    else if (name == "--threads") options.threads = std::atoi(value), ++i;
    else std::fprintf(stderr, "unknown option %s\n", name.c_str()), std::exit(2);
  }
  return options;
}

/// The plush of ../shared/look.
testing::FurredModel plush(const Options& options) {
  const FirstGroom fur{.length = 0.042, .inclination = 0.42};
  testing::FurredModel model = options.ply.empty() ? testing::furred({Builtin::creature, 20000}, fur) : testing::furred_ply(options.ply, fur);
  Coat& coat = model.settings.coat;
  coat.count = options.count, coat.width_root = 0.00044, coat.width_tip = 0.00011, coat.root_share = 0.15;
  coat.clump = 0.45, coat.clump_size = 0.025, coat.fine_clump = 0.6, coat.fine_clump_size = 0.008, coat.curl = 0.01;
  coat.ramp = {{0, {.3f, .29f, .28f}}, {.5, {.5f, .48f, .46f}}, {1, {.72f, .70f, .67f}}};
  model.settings.ground.visible = true;
  model.settings.look.colour_source = ColourSource::coat;
  return model;
}

void run(Renderer& renderer, const Options& options) {
  const testing::FurredModel model = plush(options);
  FrameRequest request = testing::small_frame(AutoView::three_quarter, options.size);
  request.knobs = knobs_of(Tier::reference);
  request.knobs.trace.passes = options.passes;
  request.tone_map = ToneMap::filmic, request.background = Background::studio;
  if (options.paths) request.knobs.trace.transport = Transport::paths;
  Tracer tracer(options.threads, std::size_t{6} << 30, false);
  const FurFrame frame = begin_trace(renderer, tracer, model, request);
  trace_to_end(tracer, [](const TraceReport& report) {
    if ((report.passes & (report.passes - 1)) != 0 && report.end == TraceEnd::none) return;
    std::printf("%8zu strands, grown in %.0f ms; %4d passes, %.0f ms, noise %.4f\n", report.strands, report.grow_ms,
                report.passes, report.trace_ms, report.noise);
    std::fflush(stdout);
  });
  if (options.out.empty()) return;
  const Result<Image> picture = renderer.finish(frame, tracer.layer(FrameLayer::beauty), nullptr);
  if (!picture) std::exit(4);
  std::ofstream(options.out, std::ios::binary) << encode_png(*picture, false);
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
  using namespace pelage::bench;
  const Options options = options_of(argc, argv);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  run(*opened.renderer, options);
}
