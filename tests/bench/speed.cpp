// Frames against the naive version at equal error: masked LDR-FLIP against the converged picture (sorted fragments) of
// the creature, spot and the torus, from three cameras each: for each number of naive shells the cheapest of our
// settings that is no further from the truth, at full and at part size; and what the tiers cost there. usage:
// bench_speed [--repetitions N] [--size PIXELS] [--truth SHELLS] [--model N] [--camera N] [--try
// SHELLS,STEPS,SCALE,ADAPTIVE]
#include <array>
#include <cstdio>
#include <span>
#include <string>

#include "renderer/compare/compare.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"
#include "tests/bench/naive_renderer.h"

namespace pelage::bench {
namespace {

constexpr std::array cameras{AutoView::three_quarter, AutoView::back, AutoView::left};
constexpr std::array naive_shells{4, 6, 8, 12, 16, 24, 32, 64};
constexpr std::array scales{1.0, 0.6};
constexpr std::array<std::array<int, 2>, 7> few_shells{{{2, 8}, {3, 8}, {4, 4}, {4, 8}, {6, 4}, {8, 2}, {8, 4}}};

struct Setup {
  int repetitions, size, truth;
  const char* tried;
};

struct Point {
  double error = 0, silhouette = 0;  // FLIP, means
  Cost cost;
};

struct Named {
  std::string name;
  Knobs knobs;
};

Knobs converged(int shells) {
  Knobs knobs;
  knobs.shells = shells, knobs.order = FragmentOrder::sorted;
  return knobs;
}

void set_error(Point& point, const Image& truth, const Image& image) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(image)));
  const Result<PictureError> error = compare(truth, image, mask);
  if (!error || !error->figures) return;
  point.error = error->figures->flip.mean;
  point.silhouette = error->figures->silhouette.value_or(FlipFigures{}).mean;
}

/// The tiers, or knobs as --try has them.
std::vector<Named> frames_of(const char* tried) {
  if (tried) {
    Knobs knobs;
    int adaptive = 0;
    std::sscanf(tried, "%d,%d,%lf,%d", &knobs.shells, &knobs.steps, &knobs.scale, &adaptive);
    knobs.shell_policy = adaptive ? ShellPolicy::adaptive : ShellPolicy::uniform;
    return {{tried, knobs}};
  }
  std::vector<Named> frames{{"draft", knobs_of(Tier::draft)}, {"interactive", knobs_of(Tier::interactive)}};
  for (const double scale : scales) {
    for (const auto& [shells, steps] : few_shells) {
      Knobs knobs;
      knobs.shells = shells, knobs.steps = steps, knobs.scale = scale;
      frames.push_back({std::to_string(shells) + " x " + std::to_string(steps) + (scale < 1 ? " at .6" : ""), knobs});
    }
  }
  return frames;
}

/// The cheapest frame of a scale that is no further from the truth than `error`.
void print_cheapest(const std::vector<Named>& frames, const std::vector<Point>& points, double scale,
                    const Point& naive) {
  std::size_t best = frames.size();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].knobs.scale != scale || points[i].error > naive.error) continue;
    if (best == frames.size() || points[i].cost.cpu < points[best].cost.cpu) best = i;
  }
  if (best == frames.size()) return static_cast<void>(std::printf("  none"));
  std::printf("  %s (%.4f) %.1f ms: %.2f times", frames[best].name.c_str(), points[best].error, points[best].cost.cpu,
              naive.cost.cpu / points[best].cost.cpu);
}

void run(const Gl& gl, Renderer& renderer, const testing::FurredModel& model, AutoView view, const Setup& setup) {
  FrameRequest request = testing::small_frame(view, setup.size);
  request.tone_map = ToneMap::filmic;
  FurFrame frame = make_frame(model.view(), request);
  const auto with = [&](const Knobs& knobs) {
    FurFrame other = frame;
    other.knobs = knobs;
    return other;
  };
  const Image truth = draw(renderer, with(converged(setup.truth)));
  const std::vector<Named> named = frames_of(setup.tried);
  std::vector<FurFrame> frames;
  for (const Named& each : named) frames.push_back(with(each.knobs));
  std::vector<NaiveRenderer> naive;
  std::vector<Point> points;
  std::vector<std::function<void()>> works;
  for (const FurFrame& each : frames) {
    set_error(points.emplace_back(), truth, draw(renderer, each));
    works.emplace_back([&renderer, &each] { draw(renderer, each); });
  }
  naive.reserve(naive_shells.size());
  for (const int shells : setup.tried ? std::span<const int>() : std::span(naive_shells)) {
    Knobs knobs;
    knobs.shells = shells, knobs.shell_policy = ShellPolicy::uniform;
    NaiveRenderer& one = naive.emplace_back(gl, model, with(knobs));
    set_error(points.emplace_back(), truth, one.draw());
    works.emplace_back([&one] { one.draw(); });
  }
  const std::vector<Cost> costs = measure_alternating(works, setup.repetitions);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].cost = costs[i];
  const std::vector<Point> curve(points.begin() + static_cast<std::ptrdiff_t>(frames.size()), points.end());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::printf("  %-12s FLIP %.4f silhouette %.4f  wall %7.1f cpu %7.1f ms\n", named[i].name.c_str(), points[i].error,
                points[i].silhouette, points[i].cost.wall, points[i].cost.cpu);
  }
  for (std::size_t i = 0; i < curve.size(); ++i) {
    std::printf("  naive %-6d FLIP %.4f silhouette %.4f  wall %7.1f cpu %7.1f ms", naive_shells[i], curve[i].error,
                curve[i].silhouette, curve[i].cost.wall, curve[i].cost.cpu);
    for (const double scale : scales) print_cheapest(named, points, scale, curve[i]);
    std::printf("\n");
  }
  std::fflush(stdout);
}

int main(int count, char** arguments) {
  const Setup setup{argument(count, arguments, "--repetitions", 5), argument(count, arguments, "--size", 512),
                    argument(count, arguments, "--truth", 512), text_argument(count, arguments, "--try")};
  const int only_model = argument(count, arguments, "--model", -1),
            only_camera = argument(count, arguments, "--camera", -1);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  for (int i = 0; i < speed_models; ++i) {
    if (only_model >= 0 && i != only_model) continue;
    const testing::FurredModel model = speed_model(i);
    testing::draw(*opened.renderer, model, testing::small_frame());
    for (int view = 0; view < 3; ++view) {
      if (only_camera >= 0 && view != only_camera) continue;
      std::printf("%s, camera %d\n", speed_name(i), view);
      run(opened.context->gl(), *opened.renderer, model, cameras[static_cast<std::size_t>(view)], setup);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
