// Rasterized strands against the traced truth, by tier and by single knobs: CPU milliseconds (minima of alternating
// repetitions), FLIP over the fur, light and coverage relative to the truth.
// usage: bench_raster [--repetitions N] [--size PIXELS] [--passes N] [--view NAME] [--triangles N]
//                     [--pictures FOLDER] [--try A_PIXEL,LIT_OF,TWICE]
// Views: creature, ground, mohawk, curly, wet, close, far, torus, sphere, sleek. A name that ends with sky has no
// lights, one that ends with sun only the first light and no ambient light. The truth is cached in the folder of
// pictures.
#include "renderer/raster/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/compare/compare.h"
#include "renderer/finish/resize.h"
#include "renderer/raster/kernels.h"
#include "server/frames/fur_view.h"
#include "server/scene/creature_settings.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

struct Variant {
  std::string name;
  std::function<void()> work;
  FloatImage image;
  RasterCounts counts;
};

struct Setup {
  int repetitions, size, passes, triangles;
  std::string view, pictures;
  const char* tried;
};

void look_at(FurCamera& camera, glm::vec3 position, glm::vec3 target) {
  camera.position = position, camera.forward = glm::normalize(target - position);
  camera.right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 1, 0)));
  camera.up = glm::cross(camera.right, camera.forward);
}

/// Adds long fur along the middle of the head and neck.
void add_mohawk(testing::FurredModel& model) {
  const Mesh& mesh = model.model.surface.mesh();
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 position(mesh.positions[v]), normal(mesh.normals[v]);
    if (std::abs(position.x) > 0.035f || normal.y < 0.2f || position.y < 0.2f) continue;
    Groom groom = model.fields.at(v);
    groom.length = 0.2f * (1 - 0.6f * std::abs(position.x) / 0.035f), groom.direction *= 0.55f;
    model.fields.set(v, stored_groom(groom.direction, groom.length, 0));
  }
}

testing::FurredModel model_of(const Setup& setup) {
  if (setup.view == "sleek") {  // short fur that lies flat
    testing::FurredModel model = testing::furred({Builtin::torus, 3000}, {.length = 0.02, .inclination = 0.9});
    model.settings = first_settings(model.model);
    model.settings.coats[0].coat.root_share = 0.7, model.settings.coats[0].coat.clump = 0.25;
    model.settings.coats[0].coat.ramp = {{0, {0.10f, 0.045f, 0.02f}}, {1, {0.28f, 0.13f, 0.06f}}};
    return model;
  }
  const bool torus = setup.view.starts_with("torus"), sphere = setup.view.starts_with("sphere");
  testing::FurredModel model = testing::furred({torus    ? Builtin::torus
                                                : sphere ? Builtin::sphere
                                                         : Builtin::creature,
                                                setup.triangles});
  model.model.name = torus ? "torus" : sphere ? "sphere" : "creature";  // selects eyes and bare skin
  model.settings = first_settings(model.model);
  if (setup.view.ends_with("sky")) model.settings.lights.clear();
  if (setup.view.ends_with("sun")) model.settings.lights.resize(1), model.settings.look.ambient = 0;
  model.settings.ground.visible = setup.view == "ground";
  Coat& coat = model.settings.coats[0].coat;
  if (setup.view == "curly") coat.curl = 0.12, coat.curl_turns = 8, coat.curl_together = 0.5, coat.clump = 0.5;
  if (setup.view == "wet") coat.wetness = 1, coat.clump = 0.6, coat.clump_size = 0.016, coat.fine_clump = 0.7;
  if (setup.view == "mohawk") add_mohawk(model);
  return model;
}

FrameRequest request_of(const Setup& setup, Tier tier) {
  FrameRequest request;
  request.width = request.height = setup.view == "far" ? setup.size / 4 : setup.size;
  request.background = Background::transparent, request.knobs = knobs_of(tier), request.tone_map = ToneMap::filmic;
  return request;
}

FurFrame frame_of(const Setup& setup, const testing::FurredModel& model, Tier tier) {
  FurFrame frame = make_frame(model.view(), request_of(setup, tier));
  if (setup.view == "far") frame.camera.position *= 1.23f;
  if (setup.view == "close") {
    look_at(frame.camera, frame.camera.position, {0.02f, 0.16f, 0.27f});
    frame.camera.tan_half_fov = std::tan(glm::radians(2.2f));
  }
  return frame;
}

FloatImage truth_of(const Setup& setup, Renderer& renderer, const testing::FurredModel& model) {
  const std::string file = setup.pictures + "/truth-" + setup.view + "-" + std::to_string(setup.size) + ".light";
  FloatImage truth;
  if (std::ifstream in(file, std::ios::binary); !setup.pictures.empty() && in) {
    in.read(reinterpret_cast<char*>(&truth.width), 4), in.read(reinterpret_cast<char*>(&truth.height), 4);
    truth.rgba.resize(4 * static_cast<std::size_t>(truth.width) * static_cast<std::size_t>(truth.height));
    in.read(reinterpret_cast<char*>(truth.rgba.data()), static_cast<std::streamsize>(truth.rgba.size() * 4));
    return truth;
  }
  FurFrame frame = frame_of(setup, model, Tier::reference);
  Tracing& trace = frame.knobs.trace;
  trace.passes = setup.passes, trace.filter = false, trace.noise = 0, trace.strands = 8'000'000;
  truth = traced_light(renderer, model.view(), frame);
  if (setup.pictures.empty()) return truth;
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&truth.width), 4), out.write(reinterpret_cast<const char*>(&truth.height), 4);
  out.write(reinterpret_cast<const char*>(truth.rgba.data()), static_cast<std::streamsize>(truth.rgba.size() * 4));
  return truth;
}

std::string errors_of(const FloatImage& truth, const FloatImage& image) {
  const Result<PictureError> error = compare(truth, image, union_of(alpha_mask(truth), alpha_mask(image)));
  if (!error || !error->figures) return "none";
  double light = 0, true_light = 0, cover = 0, true_cover = 0;
  for (std::size_t i = 0; i < truth.rgba.size(); i += 4) {
    const auto of = [&](const FloatImage& one) {
      return 0.2126 * double{one.rgba[i]} + 0.7152 * double{one.rgba[i + 1]} + 0.0722 * double{one.rgba[i + 2]};
    };
    true_cover += double{truth.rgba[i + 3]}, cover += double{image.rgba[i + 3]};
    if (truth.rgba[i + 3] > 0.5f && image.rgba[i + 3] > 0.5f) true_light += of(truth), light += of(image);
  }
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "FLIP %.4f silhouette %.4f light %.3f cover %.3f", error->figures->flip.mean,
                error->figures->silhouette.value_or(FlipFigures{}).mean, light / true_light, cover / true_cover);
  return text.data();
}

struct Bench {
  const Setup& setup;
  Renderer& renderer;
  Raster& raster;
  const testing::FurredModel& model;
  const FurModel& fur_model;
  const GrownFur& fur;
  FurFrame frame;

  void keep(const std::string& name, const FloatImage& light) const {
    if (setup.pictures.empty()) return;
    FurFrame shown = frame;
    shown.background = Background::studio;
    std::ofstream(setup.pictures + "/" + setup.view + "-" + name + ".png", std::ios::binary)
        << encode_png(renderer.finish(shown, light).value(), false);
  }
};

void add_tiers(const Bench& bench, std::vector<Variant>& variants) {
  using Named = std::pair<Tier, const char*>;
  constexpr std::array tiers{Named{Tier::draft, "draft"}, Named{Tier::interactive, "interactive"},
                             Named{Tier::detailed, "detailed"}};
  for (const auto& [tier, name] : tiers) {
    FurFrame frame = bench.frame;
    frame.knobs = knobs_of(tier);
    Renderer& renderer = bench.renderer;
    FloatImage light = std::move(renderer.draw_aovs(frame, std::array{Aov::beauty}).value()[0]);
    variants.push_back(
        {std::string("tier-") + name, [&renderer, frame] { draw(renderer, frame); }, std::move(light), {}});
  }
}

/// A quality to draw with, and `twice` for drawing at twice the size and averaging.
struct Kind {
  RasterQuality quality;
  bool twice;
};

FloatImage rasterized(const Bench& bench, const Kind& kind, RasterCounts* counts) {
  FurFrame frame = bench.frame;
  if (kind.twice) frame.width *= 2, frame.height *= 2;
  FloatImage light = bench.raster.draw(bench.fur_model, bench.fur, frame, kind.quality, counts);
  return kind.twice ? resized_light(light, bench.frame.width, bench.frame.height, 1) : light;
}

void add_raster(const Bench& bench, std::vector<Variant>& variants) {
  std::vector<Kind> kinds{{{100, 1}, false}, {{100, 2}, false}, {{100, 4}, false}, {{3, 4}, false},  {{1.5, 4}, false},
                          {{1.2, 4}, false}, {{1, 4}, false},   {{0.6, 4}, false}, {{0.4, 4}, false}};
  if (const char* tried = bench.setup.tried) {
    Kind kind{};
    int twice = 0;
    std::sscanf(tried, "%lf,%d,%d", &kind.quality.strands_a_pixel, &kind.quality.lit_of, &twice);
    kind.twice = twice != 0, kinds = {kind};
  }
  for (const Kind& kind : kinds) {
    std::array<char, 64> name{};
    std::snprintf(name.data(), name.size(), "strands-%g-%d%s", kind.quality.strands_a_pixel, kind.quality.lit_of,
                  kind.twice ? "-twice" : "");
    Variant variant{name.data(), {}, {}, {}};
    variant.image = rasterized(bench, kind, &variant.counts);
    variant.work = [&bench, kind] { rasterized(bench, kind, nullptr); };
    variants.push_back(std::move(variant));
  }
}

void print(const Variant& variant, const Cost& cost, const FloatImage& truth) {
  std::printf("  %-24s cpu %7.1f wall %7.1f | %s", variant.name.c_str(), cost.cpu, cost.wall,
              errors_of(truth, variant.image).c_str());
  const RasterCounts& c = variant.counts;
  if (c.strands > 0)
    std::printf(" | placed %zu lit %zu entries %zu MB %.1f", c.placed, c.lit, c.entries,
                static_cast<double>(c.bytes) / 1e6);
  std::printf("\n");
}

int run(const Setup& setup) {
  Renderer renderer(RendererOptions{.threads = 1});
  const testing::FurredModel model = model_of(setup);
  const FloatImage truth = truth_of(setup, renderer, model);
  sync_scene(renderer, model.view(), {});
  const FurFrame frame = frame_of(setup, model, Tier::reference);
  const ModelArrays arrays = make_arrays(model.view());
  const FurModel fur_model = make_model(model.view(), arrays);
  GrownFur fur;
  const Cost grown = measure([&] {
    fur.update(
        fur_model, make_fields(model.view(), frame.skin, {}),
        GrowRecipe{.coat = frame.coat(), .model_colours = takes_model_colours(frame.look, fur_model.has_colours)}, 1,
        frame.curves);
  });
  std::printf("%s %s: %zu strands, %.1f MB, grown in %.0f CPU ms\n", instruction_set(), setup.view.c_str(), fur.count(),
              static_cast<double>(fur.bytes()) / 1e6, grown.cpu);
  Raster raster(1);
  const Bench bench{setup, renderer, raster, model, fur_model, fur, frame};
  bench.keep("truth", truth);
  std::vector<Variant> variants;
  if (!setup.tried) add_tiers(bench, variants);
  variants.reserve(variants.size() + 32);
  add_raster(bench, variants);
  std::vector<std::function<void()>> works;
  for (const Variant& variant : variants) works.push_back(variant.work), bench.keep(variant.name, variant.image);
  const std::vector<Cost> costs = measure_alternating(works, setup.repetitions);
  for (std::size_t i = 0; i < variants.size(); ++i) print(variants[i], costs[i], truth);
  return 0;
}

int main(int count, char** arguments) {
  const char *pictures = text_argument(count, arguments, "--pictures"),
             *view = text_argument(count, arguments, "--view");
  return run({argument(count, arguments, "--repetitions", 5), argument(count, arguments, "--size", 512),
              argument(count, arguments, "--passes", 192), argument(count, arguments, "--triangles", 5000),
              view ? view : "creature", pictures ? pictures : "", text_argument(count, arguments, "--try")});
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
