// Measures traced strands of one coat: how long growing, the first picture and all passes take, and how the noise
// falls.
// usage: bench_strands [--ply FILE] [--count STRANDS] [--size PIXELS] [--passes N] [--threads N] [--paths] [--out PNG]
//                      [--stroke]     then changes a fifth of the body, and measures until the next first picture
//                      [--converge N] instead: RMSE against N passes of another seed, and the fitted slope
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "base/limits.h"
#include "renderer/image/image.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

struct Options {
  std::string ply, out;
  int count = 9000, size = 640, passes = 48, threads = 2;
  int truth = 0;  // passes of the truth of --converge; 0: without it
  bool paths = false, stroke = false;
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--paths")
      options.paths = true;
    else if (name == "--stroke")
      options.stroke = true;
    else if (name == "--converge")
      options.truth = std::atoi(value), ++i;
    else if (name == "--ply")
      options.ply = value, ++i;
    else if (name == "--out")
      options.out = value, ++i;
    else if (name == "--count")
      options.count = std::atoi(value), ++i;
    else if (name == "--size")
      options.size = std::atoi(value), ++i;
    else if (name == "--passes")
      options.passes = std::atoi(value), ++i;
    else if (name == "--threads")
      options.threads = std::atoi(value), ++i;
    else
      std::fprintf(stderr, "unknown option %s\n", name.c_str()), std::exit(2);
  }
  return options;
}

/// The plush of ../shared/look, on the creature or on a PLY file.
testing::FurredModel plush(const Options& options) {
  const FirstGroom fur{.length = 0.042, .inclination = 0.42};
  testing::FurredModel model =
      options.ply.empty() ? testing::furred({Builtin::creature, 20000}, fur) : testing::furred_file(options.ply, fur);
  Coat& coat = model.settings.coats[0].coat;
  coat.count = options.count, coat.width_root = 0.00044, coat.width_tip = 0.00011, coat.root_share = 0.15;
  coat.clump = 0.45, coat.clump_size = 0.025, coat.fine_clump = 0.6, coat.fine_clump_size = 0.008, coat.curl = 0.01;
  coat.ramp = {{0, {.3f, .29f, .28f}}, {.5, {.5f, .48f, .46f}}, {1, {.72f, .70f, .67f}}};
  model.settings.ground.visible = true;
  model.settings.look.colour_source = ColourSource::coat;
  return model;
}

/// Shortens the fur of a fifth of the vertices, those nearest to the nose.
void shorten_a_fifth(testing::FurredModel& model) {
  const std::vector<glm::vec3>& positions = model.model.surface.mesh().positions;
  std::vector<float> heights;
  for (const glm::vec3& position : positions) heights.push_back(position.z);
  const auto fifth = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 4 / 5);
  std::nth_element(heights.begin(), fifth, heights.end());
  FieldDelta::Part part{.field = Field::length, .vertices = {}, .flips = {}};
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const float length = model.fields.length()[i];
    if (positions[i].z >= *fifth) put_change(part, i, glm::vec4(length), glm::vec4(0.8f * length));
  }
  model.fields.apply({{std::move(part)}});
}

FrameRequest request_of(const Options& options) {
  FrameRequest request = testing::small_frame(AutoView::three_quarter, options.size);
  request.knobs = knobs_of(Tier::reference);
  request.knobs.trace.passes = options.passes;
  request.knobs.trace.strands = limits::strands;
  request.tone_map = ToneMap::filmic, request.background = Background::studio;
  if (options.paths) request.knobs.trace.transport = Transport::paths;
  return request;
}

void report_passes(const TraceReport& report) {
  if ((report.passes & (report.passes - 1)) != 0 && report.end == TraceEnd::none) return;
  std::printf("%8zu strands, grown and indexed in %.0f ms; %4d passes, %.0f ms, noise %.4f\n", report.strands,
              report.grow_ms, report.passes, report.trace_ms, report.noise);
  std::fflush(stdout);
}

void run(Renderer& renderer, const Options& options) {
  testing::FurredModel model = plush(options);
  FrameRequest request = request_of(options);
  Tracer tracer(options.threads, std::size_t{6} << 30, false);
  const FurFrame frame = begin_trace(renderer, tracer, model, request);
  trace_to_end(tracer, report_passes);
  if (!options.out.empty()) {
    const Result<Image> picture = renderer.finish(frame, tracer.aov(Aov::beauty), nullptr);
    if (!picture) std::exit(4);
    std::ofstream(options.out, std::ios::binary) << encode_png(*picture, false);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("most memory of the program %.2f GiB\n", static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024));
  if (!options.stroke) return;
  request.knobs.trace.passes = 1;
  begin_trace(renderer, tracer, model, request);
  std::printf("the same groom again: ");
  trace_to_end(tracer, report_passes);
  shorten_a_fifth(model);
  begin_trace(renderer, tracer, model, request);
  std::printf("after a stroke over a fifth: ");
  trace_to_end(tracer, report_passes);
}

double root_mean_square(const FloatImage& a, const FloatImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(double{a.rgba[i]} - b.rgba[i], 2);
  return std::sqrt(sum / static_cast<double>(a.rgba.size()));
}

/// Prints the RMSE of 1, 2, 4, ... passes against `truth` passes of another seed, and the slope of log error over log
/// passes.
void converge(Renderer& renderer, const Options& options) {
  const testing::FurredModel model = plush(options);
  FrameRequest request = request_of(options);
  request.knobs.trace.filter = false;
  request.knobs.trace.passes = options.truth, request.knobs.trace.seed = 999;
  Tracer tracer(options.threads, std::size_t{6} << 30, false);
  begin_trace(renderer, tracer, model, request);
  trace_to_end(tracer);
  const FloatImage truth = tracer.aov(Aov::beauty);
  request.knobs.trace.passes = options.passes, request.knobs.trace.seed = 1;
  begin_trace(renderer, tracer, model, request);
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  trace_to_end(tracer, [&](const TraceReport& report) {
    if ((report.passes & (report.passes - 1)) != 0) return;
    const FloatImage picture = tracer.aov(Aov::beauty);
    const double error = root_mean_square(picture, truth),
                 brightest = *std::max_element(picture.rgba.begin(), picture.rgba.end());
    const double log_passes = std::log2(report.passes), log_error = std::log2(error);
    n += 1, x += log_passes, y += log_error, xx += log_passes * log_passes, xy += log_passes * log_error;
    std::printf("%5d passes: RMSE %.5f, brightest %.2f, %.0f ms\n", report.passes, error, brightest, report.trace_ms);
    std::fflush(stdout);
  });
  std::printf("error falls as passes^%.3f\n", (n * xy - x * y) / (n * xx - x * x));
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
  using namespace pelage::bench;
  const Options options = options_of(argc, argv);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  options.truth > 0 ? converge(*opened.renderer, options) : run(*opened.renderer, options);
}
