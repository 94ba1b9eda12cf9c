// Fur marched on the CPU beside shells that a GL draws, at equal error: masked LDR-FLIP against sorted shells and
// against the marcher's own limit, minima of alternating repetitions. usage: bench_marched [--repetitions N] [--size
// PIXELS] [--truth SHELLS] [--model N] [--camera N] [--threads N] [--pictures FOLDER]
// [--try SHELLS,HALVINGS,DENSER,SAMPLES]
#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <fstream>
#include <string>

#include "renderer/compare/compare.h"
#include "renderer/marched/kernels.h"
#include "renderer/marched/marcher.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"
#include "tests/bench/naive_renderer.h"

namespace pelage::bench {
namespace {

constexpr std::array cameras{AutoView::three_quarter, AutoView::back, AutoView::left};
constexpr std::array naive_shells{4, 8, 16, 32, 64};
constexpr MarchQuality limit{64, 0, 1, 256};
constexpr std::array qualities{MarchQuality{4, 0, 1.5f, 16},  MarchQuality{8, 1, 1.5f, 16},
                               MarchQuality{8, 0, 1.5f, 24},  MarchQuality{16, 2, 1.5f, 24},
                               MarchQuality{16, 1, 1.5f, 32}, MarchQuality{16, 0, 1.5f, 32}};

struct Setup {
  int repetitions, size, truth;
  std::string pictures;
  const char* tried;  // a quality alone, again and again, for a profiler
};

/// One way to draw a frame.
struct Way {
  std::string name;
  std::function<void()> work;
  Image image;
};

struct Bench {
  const BenchRenderer& opened;
  Marcher& marcher;
  const testing::FurredModel& model;
  FurFrame frame;

  FurFrame with(const Knobs& knobs) const {
    FurFrame other = frame;
    other.knobs = knobs;
    return other;
  }
  Image marched(const MarchQuality& quality) const {
    return opened.renderer->finish(frame, marcher.draw(frame, quality)).value();
  }
};

Knobs shells_of(int count, FragmentOrder order = FragmentOrder::shells) {
  Knobs knobs;
  knobs.shells = count, knobs.shell_policy = ShellPolicy::uniform, knobs.order = order;
  return knobs;
}

std::string errors_of(const Image& truth, const Image& image) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(image)));
  const Result<PictureError> error = compare(truth, image, mask);
  if (!error || !error->figures) return "none";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.4f silhouette %.4f", error->figures->flip.mean,
                error->figures->silhouette.value_or(FlipFigures{}).mean);
  return text.data();
}

void keep(const Setup& setup, const std::string& scene, const std::string& name, const Image& image) {
  if (setup.pictures.empty()) return;
  std::string file = scene + "-" + name + ".png";
  for (const char apart : {' ', '/'}) std::replace(file.begin(), file.end(), apart, '-');
  std::ofstream(setup.pictures + "/" + file, std::ios::binary) << encode_png(image, false);
}

void add_gl(const Bench& bench, std::deque<NaiveRenderer>& naive, std::vector<Way>& ways) {
  for (const int shells : naive_shells) {
    NaiveRenderer& one = naive.emplace_back(bench.opened.context->gl(), bench.model, bench.with(shells_of(shells)));
    ways.push_back({"naive " + std::to_string(shells), [&one] { one.draw(); }, one.draw()});
  }
  Renderer& renderer = *bench.opened.renderer;
  for (const Tier tier : {Tier::draft, Tier::interactive}) {
    const FurFrame frame = bench.with(knobs_of(tier));
    ways.push_back({tier == Tier::draft ? "draft" : "interactive", [&renderer, frame] { draw(renderer, frame); },
                    draw(renderer, frame)});
  }
}

void add_marched(const Bench& bench, std::vector<Way>& ways) {
  for (const MarchQuality& quality : qualities) {
    const std::string name =
        std::to_string(quality.shells) + "/" + std::to_string(quality.halvings) + " " + std::to_string(quality.samples);
    ways.push_back({name, [&bench, &quality] { bench.marcher.draw(bench.frame, quality); }, bench.marched(quality)});
  }
}

/// Shells, how often they are halved inside, samples: "8/1 16".
void run(const Bench& bench, const std::string& scene, const Setup& setup) {
  std::deque<NaiveRenderer> naive;  // which stay where they are
  std::vector<Way> ways;
  add_gl(bench, naive, ways);
  add_marched(bench, ways);
  std::vector<std::function<void()>> works;
  for (const Way& way : ways) works.push_back(way.work);
  const std::vector<Cost> costs = measure_alternating(works, setup.repetitions);
  const Image sorted = draw(*bench.opened.renderer, bench.with(shells_of(setup.truth, FragmentOrder::sorted)));
  const Image own = bench.marched(limit);
  std::printf("%s: limit to sorted %s\n", scene.c_str(), errors_of(sorted, own).c_str());
  keep(setup, scene, "sorted", sorted), keep(setup, scene, "limit", own);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    keep(setup, scene, ways[i].name, ways[i].image);
    std::printf("  %-12s cpu %7.1f wall %7.1f | sorted %s | limit %s\n", ways[i].name.c_str(), costs[i].cpu,
                costs[i].wall, errors_of(sorted, ways[i].image).c_str(), errors_of(own, ways[i].image).c_str());
  }
  std::fflush(stdout);
}

void profile(const Bench& bench, const Setup& setup) {
  MarchQuality quality;
  std::sscanf(setup.tried, "%d,%d,%f,%d", &quality.shells, &quality.halvings, &quality.denser, &quality.samples);
  Cost cost;
  MarchTimes times;
  for (int i = 0; i < setup.repetitions; ++i)
    cost.lower_to(measure([&] { bench.marcher.draw(bench.frame, quality, &times); }));
  std::printf("  cpu %.1f wall %.1f ms: vertices %.1f bins %.1f tiles %.1f\n", cost.cpu, cost.wall, times.vertices,
              times.bins, times.tiles);
}

void run_view(const BenchRenderer& opened, Marcher& marcher, const testing::FurredModel& model, std::size_t view,
              const std::string& scene, const Setup& setup) {
  FrameRequest request = testing::small_frame(cameras[view], setup.size);
  request.tone_map = ToneMap::filmic;
  const Bench bench{opened, marcher, model, make_frame(model.view(), request)};
  const ModelArrays arrays = make_arrays(model.view());
  const FurModel fur_model = make_model(model.view(), arrays);
  if (!marcher.has(fur_model.id)) marcher.add(fur_model, make_fields(model.view(), bench.frame.skin, {}));
  setup.tried ? profile(bench, setup) : run(bench, scene, setup);
}

int main(int count, char** arguments) {
  const char* pictures = text_argument(count, arguments, "--pictures");
  const Setup setup{argument(count, arguments, "--repetitions", 5), argument(count, arguments, "--size", 512),
                    argument(count, arguments, "--truth", 64), pictures ? pictures : "",
                    text_argument(count, arguments, "--try")};
  const int only_model = argument(count, arguments, "--model", -1),
            only_camera = argument(count, arguments, "--camera", -1);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  Marcher marcher(argument(count, arguments, "--threads", 2));
  std::printf("%s\n", instruction_set());
  for (int i = 0; i < speed_models; ++i) {
    if (only_model >= 0 && i != only_model) continue;
    const testing::FurredModel model = speed_model(i);
    testing::draw(*opened.renderer, model, testing::small_frame());
    for (std::size_t view = 0; view < cameras.size(); ++view) {
      if (only_camera < 0 || static_cast<int>(view) == only_camera)
        run_view(opened, marcher, model, view, speed_name(i) + std::to_string(view), setup);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
