// Frames of shells and of rasterized strands against a naive renderer of the same fur in the same run: minima of
// alternating repetitions, wall-clock and CPU milliseconds.
// usage: bench_frames [--repetitions N] [--size PIXELS] [--ply FILE] [--most-difference D]
// With --most-difference it fails if a picture of shells and its naive counterpart differ by more than D/255 on
// average.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"
#include "tests/bench/naive_renderer.h"

namespace pelage::bench {
namespace {

/// Prints one row. Returns the mean difference between the picture of shells and the naive one, in 1/255.
double run(const Gl& gl, Renderer& renderer, const char* name, const testing::FurredModel& model, int size,
           int repetitions) {
  FrameRequest request = testing::small_frame(AutoView::three_quarter, size);
  request.background = Background::colour;
  request.tone_map = ToneMap::filmic;
  request.knobs.method = Method::shells;
  const Image picture = testing::draw(renderer, model, request);
  const FurFrame frame = make_frame(model.view(), request);
  FurFrame strands = frame;
  strands.knobs = knobs_of(Tier::interactive);
  NaiveRenderer naive(gl, model, frame);
  const double difference = testing::mean_difference(picture, naive.draw());
  Cost ours, rasterized, theirs;
  for (int i = 0; i < repetitions; ++i) {
    theirs.lower_to(measure([&] { naive.draw(); }));
    ours.lower_to(measure([&] { draw(renderer, frame); }));
    rasterized.lower_to(measure([&] { draw(renderer, strands); }));
  }
  std::printf("%-9s %7zu %5d | %8.1f %8.1f | %8.1f %8.1f %5.2f | %8.1f %8.1f %5.2f | %5.2f\n", name,
              model.model.surface.mesh().triangles.size(), size, theirs.wall, theirs.cpu, ours.wall, ours.cpu,
              theirs.cpu / ours.cpu, rasterized.wall, rasterized.cpu, theirs.cpu / rasterized.cpu, difference);
  std::fflush(stdout);
  return difference;
}

int main(int count, char** arguments) {
  int repetitions = 7, size = 512;
  double max_difference = 255;
  std::string ply;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = arguments[i];
    if (name == "--repetitions")
      repetitions = std::atoi(arguments[i + 1]);
    else if (name == "--size")
      size = std::atoi(arguments[i + 1]);
    else if (name == "--ply")
      ply = arguments[i + 1];
    else if (name == "--most-difference")
      max_difference = std::atof(arguments[i + 1]);
    else
      return std::fprintf(stderr, "unknown argument %s\n", name.c_str()), 2;
  }
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  std::printf("%-9s %7s %5s | %17s | %17s %5s | %17s %5s | mean difference /255\n", "16 shells", "tri", "px",
              "naive: wall cpu ms", "ours: wall cpu", "ratio", "strands: wall cpu", "ratio");
  double difference = 0;
  const auto add = [&](const char* name, const testing::FurredModel& model) {
    difference = std::max(difference, run(opened.context->gl(), *opened.renderer, name, model, size, repetitions));
  };
  add("torus", testing::furred({Builtin::torus, 5000}));
  add("creature", testing::furred({Builtin::creature, 5000}));
  if (ply.empty())
    add("creature", testing::furred({Builtin::creature, 100000}));
  else
    add("file", testing::furred_file(ply));
  return difference <= max_difference ? 0 : 1;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
