// Non-uniform shells against uniform ones at the same error: masked LDR-FLIP against a converged picture (sorted
// fragments) of the creature at three distances, beside fragments and CPU time; then what overlapping patches cost.
// usage: bench_shell_lod [--repetitions N] [--size PIXELS] [--truth SHELLS]
#include <cmath>
#include <cstdio>

#include "renderer/compare/compare.h"
#include "server/frames/fur_view.h"
#include "server/patches/patches.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

struct Setup {
  int repetitions, size, truth;
};

struct Point {
  double error = 0, silhouette = 0;  // FLIP, means
  double fragments = 0, cpu = 0;     // of the frame
};

FurFrame frame_of(const testing::FurredModel& model, int size, float distance) {
  FrameRequest request = testing::small_frame(AutoView::three_quarter, size);
  request.tone_map = ToneMap::filmic;
  FurFrame frame = make_frame(model.view(), request);
  frame.camera.position *= distance;
  return frame;
}

FurFrame with(FurFrame frame, ShellPolicy policy, int shells) {
  frame.knobs.shell_policy = policy, frame.knobs.shells = shells;
  return frame;
}

FlipFigures flip_of(const Image& truth, const Image& image, double& silhouette) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(image)));
  const Result<PictureError> error = compare(truth, image, mask);
  if (!error || !error->figures) return {};
  silhouette = error->figures->silhouette.value_or(FlipFigures{}).mean;
  return error->figures->flip;
}

std::vector<Point> points_of(Renderer& renderer, const std::vector<FurFrame>& frames, const Image& truth,
                             int repetitions) {
  std::vector<Point> points(frames.size());
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    DrawTimes times;
    const Image image = draw(renderer, frames[i], &times);
    points[i].error = flip_of(truth, image, points[i].silhouette).mean;
    points[i].fragments = static_cast<double>(times.counters.fragments);
    works.emplace_back([&renderer, &frame = frames[i]] { draw(renderer, frame); });
  }
  const std::vector<Cost> costs = measure_alternating(works, repetitions);
  for (std::size_t i = 0; i < frames.size(); ++i) points[i].cpu = costs[i].cpu;
  return points;
}

/// The cost at which the curve has this error: linear between logarithms, none outside the curve.
double cost_at(const std::vector<Point>& curve, double error, double Point::*cost) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point &a = curve[i - 1], &b = curve[i];
    if (error > a.error || error < b.error) continue;
    const double t = std::log(a.error / error) / std::log(a.error / b.error);
    return a.*cost * std::pow(b.*cost / (a.*cost), t);
  }
  return NAN;
}

void run(Renderer& renderer, const testing::FurredModel& model, float distance, const Setup& setup) {
  FurFrame frame = frame_of(model, setup.size, distance), converged = with(frame, ShellPolicy::uniform, setup.truth);
  converged.knobs.order = FragmentOrder::sorted;
  const Image truth = draw(renderer, converged);
  converged.knobs.shells /= 2;
  double silhouette = 0;
  const double half = flip_of(truth, draw(renderer, converged), silhouette).mean;
  std::printf("\ndistance %.2f of the view that frames the model; %d sorted shells against %d: FLIP %.4f\n",
              static_cast<double>(distance), setup.truth, setup.truth / 2, half);
  std::printf("%8s | %-38s | %-38s | at equal error\n", "shells", "uniform: FLIP, silhouette, Mfragm., CPU ms",
              "adaptive");

  const std::vector<int> counts = {2, 4, 6, 8, 12, 16, 24, 32};
  std::vector<FurFrame> frames;
  for (const ShellPolicy policy : {ShellPolicy::uniform, ShellPolicy::adaptive}) {
    for (const int shells : counts) frames.push_back(with(frame, policy, shells));
  }
  const std::vector<Point> all = points_of(renderer, frames, truth, setup.repetitions);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(counts.size());
  const std::vector<Point> uniform(all.begin(), middle), adaptive(middle, all.end());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Point &u = uniform[i], &a = adaptive[i];
    std::printf("%8d | %8.4f %8.4f %10.3f %8.1f | %8.4f %8.4f %10.3f %8.1f | fragments %.2f, CPU %.2f\n", counts[i],
                u.error, u.silhouette, u.fragments / 1e6, u.cpu, a.error, a.silhouette, a.fragments / 1e6, a.cpu,
                a.fragments / cost_at(uniform, a.error, &Point::fragments),
                a.cpu / cost_at(uniform, a.error, &Point::cpu));
  }
  std::fflush(stdout);
}

double fragments_of(Renderer& renderer, const testing::FurredModel& model, int size) {
  DrawTimes times;
  testing::draw(renderer, model, testing::small_frame(AutoView::three_quarter, size));
  draw(renderer, frame_of(model, size, 1), &times);
  return static_cast<double>(times.counters.fragments);
}

void overlap(Renderer& renderer, const char* name, testing::FurredModel model, int size) {
  const double soft = fragments_of(renderer, model, size);
  renderer.forget(model.model.id);
  model.model.patches = hard_pieces(model.model.patches);
  const double hard = fragments_of(renderer, model, size);
  renderer.forget(model.model.id);
  std::printf("%-9s fragments with soft patches %.3f M, with hard ones %.3f M: %.3f\n", name, soft / 1e6, hard / 1e6,
              soft / hard);
}

int main(int count, char** arguments) {
  const Setup setup{argument(count, arguments, "--repetitions", 3), argument(count, arguments, "--size", 512),
                    argument(count, arguments, "--truth", 512)};
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  const testing::FurredModel creature = testing::furred({Builtin::creature, 5000});
  testing::draw(*opened.renderer, creature, testing::small_frame());
  for (const float distance : {0.5f, 1.0f, 2.0f}) run(*opened.renderer, creature, distance, setup);
  std::printf("\n");
  overlap(*opened.renderer, "creature", testing::furred({Builtin::creature, 5000}), setup.size);
  overlap(*opened.renderer, "creature", testing::furred({Builtin::creature, 20000}), setup.size);
  overlap(*opened.renderer, "torus", testing::furred({Builtin::torus, 5000}), setup.size);
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
