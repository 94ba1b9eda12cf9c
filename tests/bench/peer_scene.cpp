// Writes one furry torus for several renderers, and compares their pictures (tests/bench/peers).
// usage: bench_peer_scene write FOLDER [--size PIXELS] [--passes N] [--truth N]
//          writes the scene as files, our pictures as ours_1.exr, ours_2.exr, ours_4.exr, ... and ours_truth.exr, which
//          has another seed; ours.txt has a line for each: samples, wall-clock and CPU seconds since the request
//        bench_peer_scene compare FOLDER PEER [--size PIXELS]
//          compares ours with PEER_1.exr, ... and PEER.txt of the same format: the error against each renderer's own
//          truth, seconds, and how alike the two truths are; writes both truths as JPEG
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/colour_space.h"
#include "renderer/compare/compare.h"
#include "renderer/image/float_image.h"
#include "renderer/picture_files/picture_files.h"
#include "tests/bench/peer_torus.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

struct Options {
  std::string folder, peer;
  int size = 256, passes = 64, truth = 1024;
};

[[noreturn]] void stop(const std::string& why) { std::fprintf(stderr, "%s\n", why.c_str()), std::exit(4); }

void write_exr(const FloatImage& light, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << picture_files().encode_exr({light.width, light.height}, rgba_planes(light.rgba, ExrSample::single));
  if (!file.flush()) stop("cannot write " + path);
}

FloatImage read_exr(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  Result<FloatImage> image = picture_files().decode_float_image(std::as_bytes(std::span(bytes)), std::size_t{1} << 26);
  return image ? std::move(image).value() : (stop(path + ": " + image.status().message), FloatImage{});
}

/// Traces ours_1.exr, ours_2.exr, ... and adds a line to `times` for each; with `truth` traces ours_truth.exr alone.
void trace_ours(Renderer& renderer, const testing::FurredModel& model, const Options& options, bool truth,
                std::ostream& times) {
  const FrameRequest request = peer_request(options.size, truth ? options.truth : options.passes, truth ? 2 : 1);
  Tracer tracer(2, std::size_t{6} << 30, false);
  Cost spent = measure([&] { begin_trace(renderer, tracer, model, request); });
  times << "0 " << spent.wall / 1e3 << ' ' << spent.cpu / 1e3 << '\n';
  while (tracer.report().end == TraceEnd::none) {
    const Cost pass = measure([&] {
      if (const Status added = tracer.add_pass([] { return true; }); !added.ok()) stop(added.message);
    });
    spent.wall += pass.wall, spent.cpu += pass.cpu;
    const int passes = tracer.report().passes;
    if (truth || (passes & (passes - 1)) != 0) continue;
    times << passes << ' ' << spent.wall / 1e3 << ' ' << spent.cpu / 1e3 << std::endl;
    write_exr(tracer.aov(Aov::beauty), options.folder + "/ours_" + std::to_string(passes) + ".exr");
  }
  if (truth) write_exr(tracer.aov(Aov::beauty), options.folder + "/ours_truth.exr");
}

void write_all(Renderer& renderer, const Options& options) {
  const testing::FurredModel model = peer_torus();
  const FurFrame frame = make_frame(model.view(), peer_request(options.size, 1, 1));
  const std::size_t strands = write_peer_scene(model, frame, options.folder);
  Tracer tracer(2, std::size_t{6} << 30, false);
  begin_trace(renderer, tracer, model, peer_request(options.size, 1, 1));
  if (strands == 0 || strands != tracer.report().strands)
    stop("not the strands that are traced: a small picture has fewer and wider ones");
  std::printf("%zu strands\n", strands);
  std::ofstream times(options.folder + "/ours.txt");
  trace_ours(renderer, model, options, false, times);
  std::ofstream unused;
  if (options.truth > 0) trace_ours(renderer, model, options, true, unused);
}

struct Run {
  int samples = 0;
  double wall = 0, cpu = 0, error = 0;
};

double error_of(const FloatImage& a, const FloatImage& b) {
  if (a.rgba.size() != b.rgba.size()) stop("pictures of different sizes");
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const double off = i % 4 == 3 ? 0 : a.rgba[i] - b.rgba[i];
    sum += off * off;
  }
  return std::sqrt(sum / (0.75 * static_cast<double>(a.rgba.size())));
}

std::vector<Run> read_runs(const std::string& start, const FloatImage& truth) {
  std::vector<Run> runs;
  std::ifstream file(start + ".txt");
  for (Run run; file >> run.samples >> run.wall >> run.cpu;) {
    if (run.samples > 0) run.error = error_of(read_exr(start + "_" + std::to_string(run.samples) + ".exr"), truth);
    runs.push_back(run);
  }
  return runs;
}

/// Lines through the runs: log error over log samples, by least squares; and CPU seconds over samples, through the runs
/// with the fewest and the most samples.
struct Fit {
  double power = 0, at_one = 0, start = 0, each = 0;

  double samples(double error) const { return std::pow(error / at_one, 1 / power); }
  double seconds(double error) const { return start + each * samples(error); }
};

Fit fit_of(const std::vector<Run>& runs) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  const Run* min = nullptr;
  const Run* max = nullptr;
  for (const Run& run : runs) {
    if (run.samples == 0) continue;
    const double u = std::log(run.samples), v = std::log(run.error);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
    if (!min || run.samples < min->samples) min = &run;
    if (!max || run.samples > max->samples) max = &run;
  }
  if (n < 2) stop("too few pictures");
  Fit fit;
  fit.power = (n * xy - x * y) / (n * xx - x * x), fit.at_one = std::exp((y - fit.power * x) / n);
  fit.each = (max->cpu - min->cpu) / (max->samples - min->samples);
  fit.start = min->cpu - fit.each * min->samples;
  return fit;
}

Fit print_runs(const std::string& name, const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.samples == 0) continue;
    std::printf("%-8s %5d samples  RMSE %.5f  wall %7.2f s  CPU %7.2f s\n", name.c_str(), run.samples, run.error,
                run.wall, run.cpu);
  }
  const Fit fit = fit_of(runs);
  std::printf("%-8s RMSE %.4f N^%.3f, CPU %.2f s + %.4f s N\n", name.c_str(), fit.at_one, fit.power, fit.start,
              fit.each);
  return fit;
}

double mean_luminance(const FloatImage& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    sum += luminance(glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]));
  return sum / (0.25 * static_cast<double>(image.rgba.size()));
}

double coverage(const FloatImage& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) sum += image.rgba[i];
  return sum;
}

void print_likeness(const FloatImage& ours, const FloatImage& theirs) {
  const Result<PictureError> error = compare(theirs, ours, union_of(alpha_mask(ours), alpha_mask(theirs)));
  if (!error || !error->figures) stop("cannot be compared");
  std::printf("ours over theirs: luminance %.4f, coverage %.4f; FLIP mean %.4f, 95th percentile %.4f; RMSE %.5f\n",
              mean_luminance(ours) / mean_luminance(theirs), coverage(ours) / coverage(theirs),
              error->figures->flip.mean, error->figures->flip.percentile_95, error->figures->rmse);
}

void compare_all(Renderer& renderer, const Options& options) {
  const std::string ours = options.folder + "/ours", theirs = options.folder + "/" + options.peer;
  const FloatImage our_truth = read_exr(ours + "_truth.exr"), their_truth = read_exr(theirs + "_truth.exr");
  const testing::FurredModel model = peer_torus();
  const FurFrame frame = make_frame(model.view(), peer_request(our_truth.width, 1, 1));
  sync_scene(renderer, model.view(), {});
  for (const auto& [path, light] : {std::pair{ours, &our_truth}, {theirs, &their_truth}}) {
    const Result<Image> picture = renderer.finish(frame, *light, nullptr);
    if (!picture) stop(picture.status().message);
    std::ofstream(path + ".jpg", std::ios::binary) << picture_files().encode_jpeg(*picture, 90);
  }
  print_likeness(our_truth, their_truth);
  const std::vector<Run> our_runs = read_runs(ours, our_truth), their_runs = read_runs(theirs, their_truth);
  const Fit us = print_runs("ours", our_runs), them = print_runs(options.peer, their_runs);
  for (const Run& run : our_runs) {
    if (run.samples < 4) continue;
    const double mine = us.each * us.samples(run.error), other = them.each * them.samples(run.error);
    std::printf("RMSE %.5f: ours %.2f s, %s %.2f s, share %.3f; tracing alone %.2f s, %.2f s, %.3f\n", run.error,
                us.seconds(run.error), options.peer.c_str(), them.seconds(run.error),
                us.seconds(run.error) / them.seconds(run.error), mine, other, mine / other);
  }
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
  using namespace pelage::bench;
  const std::string action = argc > 2 ? argv[1] : "";
  const int first = action == "write" ? 3 : 4;
  if ((action != "write" && action != "compare") || argc < first)
    return std::fprintf(stderr, "write or compare, and a folder\n"), 2;
  Options options{.folder = argv[2], .peer = first == 4 ? argv[3] : ""};
  for (int i = first; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--size")
      options.size = std::atoi(argv[i + 1]);
    else if (name == "--passes")
      options.passes = std::atoi(argv[i + 1]);
    else if (name == "--truth")
      options.truth = std::atoi(argv[i + 1]);
    else
      return std::fprintf(stderr, "unknown option %s\n", name.c_str()), 2;
  }
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  if (action == "write")
    write_all(*opened.renderer, options);
  else
    compare_all(*opened.renderer, options);
}
