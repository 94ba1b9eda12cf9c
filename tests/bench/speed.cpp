// Frames against the naive version at equal error: masked LDR-FLIP against the converged picture (sorted fragments) of
// the creature, spot and the torus, from three cameras each, and what the tiers cost there.
// usage: bench_speed [--repetitions N] [--size PIXELS] [--truth SHELLS] [--model N] [--camera N] [--try SHELLS,STEPS,SCALE,BANDS,ADAPTIVE]
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>

#include "renderer/compare/compare.h"
#include "server/scene/fur_view.h"
#include "tests/bench/measure.h"
#include "tests/bench/naive_renderer.h"

namespace pelage::bench {
namespace {

constexpr std::array cameras{AutoView::three_quarter, AutoView::back, AutoView::left};
constexpr std::array naive_shells{4, 6, 8, 12, 16, 24, 32, 64};

struct Setup {
  int repetitions, size, truth;
  const char* tried;
};

struct Point {
  double error = 0, outline = 0;  // FLIP, means
  Cost cost;
};

struct Named {
  const char* name;
  Knobs knobs;
};

/// The converged picture with shadows of its own kind.
Knobs sorted(int shells, bool shadow_maps) {
  Knobs knobs;
  knobs.shadow_maps = shadow_maps;
  if (shadow_maps) knobs.shadow_resolution = knobs_of(Tier::detailed).shadow_resolution;
  knobs.shells = shells, knobs.shell_policy = ShellPolicy::uniform;
  knobs.accumulation = Accumulation::full, knobs.order = FragmentOrder::sorted;
  return knobs;
}

void set_error(Point& point, const Image& truth, const Image& image) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(image)));
  const Result<PictureError> error = compare(truth, image, mask);
  if (!error || !error->figures) return;
  point.error = error->figures->flip.mean;
  point.outline = error->figures->outline.value_or(FlipFigures{}).mean;
}

/// The cost at which the curve first has this error: linear between logarithms; NAN where it never does.
double cost_at(const std::vector<Point>& curve, double error) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].error > error) continue;
    if (i == 0) return curve[0].cost.cpu;
    const Point &a = curve[i - 1], &b = curve[i];
    const double t = std::log(a.error / error) / std::log(a.error / b.error);
    return a.cost.cpu * std::pow(b.cost.cpu / a.cost.cpu, t);
  }
  return NAN;
}

/// The tiers, or knobs as --try has them.
std::vector<Named> frames_of(const char* tried) {
  if (tried) {
    Knobs knobs;
    int adaptive = 0;
    std::sscanf(tried, "%d,%d,%lf,%d,%d", &knobs.shells, &knobs.steps, &knobs.scale, &knobs.bands, &adaptive);
    knobs.shell_policy = adaptive ? ShellPolicy::adaptive : ShellPolicy::uniform;
    return {{tried, knobs}};
  }
  return {{"draft", knobs_of(Tier::draft)}, {"interactive", knobs_of(Tier::interactive)}, {"detailed", knobs_of(Tier::detailed)}};
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
  const Image truth = draw(renderer, with(sorted(setup.truth, false))), mapped = draw(renderer, with(sorted(setup.truth, true)));
  std::vector<FurFrame> frames;
  for (const Named& named : frames_of(setup.tried)) frames.push_back(with(named.knobs));
  std::vector<NaiveRenderer> naive;
  std::vector<Point> points;
  std::vector<std::function<void()>> works;
  for (const FurFrame& each : frames) {
    set_error(points.emplace_back(), each.knobs.shadow_maps ? mapped : truth, draw(renderer, each));
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
  for (std::size_t i = 0; i < curve.size(); ++i) {
    std::printf("  naive %3d    FLIP %.4f outline %.4f  wall %7.1f cpu %7.1f ms\n", naive_shells[i], curve[i].error,
                curve[i].outline, curve[i].cost.wall, curve[i].cost.cpu);
  }
  const std::vector<Named> names = frames_of(setup.tried);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::printf("  %-12s FLIP %.4f outline %.4f  wall %7.1f cpu %7.1f ms  naive at equal FLIP costs %.2f times\n", names[i].name,
                points[i].error, points[i].outline, points[i].cost.wall, points[i].cost.cpu,
                cost_at(curve, points[i].error) / points[i].cost.cpu);
  }
  std::fflush(stdout);
}

const char* text(int count, char** arguments, const std::string& name) {
  for (int i = 1; i + 1 < count; ++i) {
    if (arguments[i] == name) return arguments[i + 1];
  }
  return nullptr;
}

int main(int count, char** arguments) {
  const Setup setup{argument(count, arguments, "--repetitions", 5), argument(count, arguments, "--size", 512),
                    argument(count, arguments, "--truth", 512), text(count, arguments, "--try")};
  const int only_model = argument(count, arguments, "--model", -1), only_camera = argument(count, arguments, "--camera", -1);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  const std::array<const char*, 3> names{"creature", "spot", "torus"};
  for (int i = 0; i < 3; ++i) {
    if (only_model >= 0 && i != only_model) continue;
    const testing::FurredModel model = i == 0   ? testing::furred({Builtin::creature, 5000})
                                       : i == 1 ? testing::furred_ply("../shared/meshes/spot.ply")
                                                : testing::furred({Builtin::torus, 5000});
    testing::draw(*opened.renderer, model, testing::small_frame());
    for (int view = 0; view < 3; ++view) {
      if (only_camera >= 0 && view != only_camera) continue;
      std::printf("%s, camera %d\n", names[static_cast<std::size_t>(i)], view);
      run(opened.context->gl(), *opened.renderer, model, cameras[static_cast<std::size_t>(view)], setup);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
