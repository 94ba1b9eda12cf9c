// Fur marched on the CPU beside shells that a GL draws, at equal error: masked LDR-FLIP against sorted shells and
// against the marcher's own limit, minima of alternating repetitions. usage: bench_marched [--repetitions N] [--size
// PIXELS]
// [--truth SHELLS] [--model N] [--camera N] [--threads N] [--pictures FOLDER]
// [--try SHELLS,HALVINGS,DENSER,SAMPLES]
#include <array>
#include <cstdio>
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

struct Setup {
  int repetitions, size, truth;
  std::string pictures;
  MarchQuality tried{0, 0, 1.5f, 1};
};

struct Drawn {
  std::string name;
  Image image;
};

void keep(const Setup& setup, const std::string& scene, const Drawn& drawn) {
  if (setup.pictures.empty()) return;
  std::string name = setup.pictures + "/" + scene + "-" + drawn.name + ".png";
  std::replace(name.begin(), name.end(), ' ', '_');
  std::ofstream(name, std::ios::binary) << encode_png(drawn.image, false);
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

/// One quality again and again, for a profiler.
void profile(Marcher& marcher, const FurFrame& frame, const Setup& setup) {
  Cost cost;
  MarchTimes times;
  for (int i = 0; i < setup.repetitions; ++i) cost.lower_to(measure([&] { marcher.draw(frame, setup.tried, &times); }));
  std::printf("  cpu %.1f wall %.1f ms: vertices %.1f bins %.1f tiles %.1f\n", cost.cpu, cost.wall, times.vertices,
              times.bins, times.tiles);
}

void run(const BenchRenderer& opened, Marcher& marcher, const testing::FurredModel& model, const std::string& scene,
         AutoView view, const Setup& setup) {
  Renderer& renderer = *opened.renderer;
  FrameRequest request = testing::small_frame(view, setup.size);
  request.tone_map = ToneMap::filmic;
  FurFrame frame = make_frame(model.view(), request);

  const ModelArrays arrays = make_arrays(model.view());
  const FurModel fur_model = make_model(model.view(), arrays);
  if (!marcher.has(fur_model.id)) marcher.add(fur_model, make_fields(model.view(), frame.skin, {}));
  const auto with = [&](const Knobs& knobs) {
    FurFrame other = frame;
    other.knobs = knobs;
    return other;
  };
  const auto marched = [&](const MarchQuality& quality, MarchTimes* times = nullptr) {
    return renderer.finish(frame, marcher.draw(frame, quality, times)).value();
  };
  if (setup.tried.shells > 0) return profile(marcher, frame, setup);
  Knobs converged;
  converged.shells = setup.truth, converged.order = FragmentOrder::sorted;
  const Drawn truth{"sorted", draw(renderer, with(converged))};
  const Drawn limit{"limit", marched({64, 0, 1, 256})};
  struct Named {
    std::string name;
    MarchQuality quality;
  };
  const std::vector<Named> qualities{
      {"4 16", {4, 0, 1.5f, 16}},          {"4 32", {4, 0, 1.5f, 32}},     {"6 24", {6, 0, 1.5f, 24}},
      {"8 24", {8, 0, 1.5f, 24}},          {"8/1 12", {8, 1, 1.5f, 12}},   {"8/1 16", {8, 1, 1.5f, 16}},
      {"8/1 24", {8, 1, 1.5f, 24}},        {"8/1 32", {8, 1, 1.5f, 32}},   {"8/1 24:2", {8, 1, 1.5f, 24, 2}},
      {"16/2 16", {16, 2, 1.5f, 16}},      {"16/2 24", {16, 2, 1.5f, 24}}, {"16/2 32", {16, 2, 1.5f, 32}},
      {"16/2 24:2", {16, 2, 1.5f, 24, 2}}, {"16/1 32", {16, 1, 1.5f, 32}}, {"16 32", {16, 0, 1.5f, 32}},
      {"32/2 48", {32, 2, 1.5f, 48}}};
  std::vector<std::function<void()>> works;
  std::vector<Drawn> drawn;
  std::vector<std::string> notes;
  NaiveRenderer naive8(opened.context->gl(), model, with([] {
                         Knobs k;
                         k.shells = 8;
                         k.shell_policy = ShellPolicy::uniform;
                         return k;
                       }()));
  NaiveRenderer naive16(opened.context->gl(), model, with([] {
                          Knobs k;
                          k.shells = 16;
                          k.shell_policy = ShellPolicy::uniform;
                          return k;
                        }()));
  drawn.push_back({"naive 8", naive8.draw()}), works.emplace_back([&] { naive8.draw(); });
  drawn.push_back({"naive 16", naive16.draw()}), works.emplace_back([&] { naive16.draw(); });
  const FurFrame interactive = with(knobs_of(Tier::interactive)), draft = with(knobs_of(Tier::draft));
  drawn.push_back({"draft", draw(renderer, draft)});
  works.emplace_back([&] { renderer.clear_view_cache(), draw(renderer, draft); });
  drawn.push_back({"interactive", draw(renderer, interactive)});
  works.emplace_back([&] { renderer.clear_view_cache(), draw(renderer, interactive); });
  notes.resize(drawn.size());
  for (const Named& named : qualities) {
    MarchTimes times;
    drawn.push_back({named.name, marched(named.quality, &times)});
    works.emplace_back([&marcher, &frame, &named] { marcher.draw(frame, named.quality); });
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "vertices %.1f bins %.1f tiles %.1f", times.vertices, times.bins,
                  times.tiles);
    notes.emplace_back(text.data());
  }
  const std::vector<Cost> costs = measure_alternating(works, setup.repetitions);
  std::printf("%s: limit to sorted %s\n", scene.c_str(), errors_of(truth.image, limit.image).c_str());
  keep(setup, scene, truth), keep(setup, scene, limit);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    keep(setup, scene, drawn[i]);
    std::printf("  %-12s cpu %7.1f wall %7.1f | sorted %s | limit %s | %s\n", drawn[i].name.c_str(), costs[i].cpu,
                costs[i].wall, errors_of(truth.image, drawn[i].image).c_str(),
                errors_of(limit.image, drawn[i].image).c_str(), notes[i].c_str());
  }
  std::fflush(stdout);
}

const char* text(int count, char** arguments, const std::string& name) {
  for (int i = 1; i + 1 < count; ++i) {
    if (arguments[i] == name) return arguments[i + 1];
  }
  return "";
}

int main(int count, char** arguments) {
  Setup setup{argument(count, arguments, "--repetitions", 5),
              argument(count, arguments, "--size", 512),
              argument(count, arguments, "--truth", 64),
              text(count, arguments, "--pictures"),
              {0, 0, 1.5f, 1}};
  std::sscanf(text(count, arguments, "--try"), "%d,%d,%f,%d", &setup.tried.shells, &setup.tried.halvings,
              &setup.tried.denser, &setup.tried.samples);
  const int only_model = argument(count, arguments, "--model", -1),
            only_camera = argument(count, arguments, "--camera", -1);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  Marcher marcher(argument(count, arguments, "--threads", 2));
  std::printf("%s\n", instruction_set());
  const std::array<const char*, 3> names{"creature", "spot", "torus"};
  for (int i = 0; i < 3; ++i) {
    if (only_model >= 0 && i != only_model) continue;
    const testing::FurredModel model = i == 0   ? testing::furred({Builtin::creature, 5000})
                                       : i == 1 ? testing::furred_ply("../shared/meshes/spot.ply")
                                                : testing::furred({Builtin::torus, 5000});
    testing::draw(*opened.renderer, model, testing::small_frame());
    for (std::size_t view = 0; view < cameras.size(); ++view) {
      if (only_camera < 0 || static_cast<int>(view) == only_camera)
        run(opened, marcher, model, std::string(names[static_cast<std::size_t>(i)]) + std::to_string(view),
            cameras[view], setup);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
