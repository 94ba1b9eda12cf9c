// Shells beside traced strands: coverage, mean luminance and FLIP on twelve scenes.
// usage: bench_methods [--size PIXELS] [--passes N] [--scenes FIRST_N] [--distance TIMES] [--paths] [--out FOLDER]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <span>
#include <string>

#include "protocol/base/colour_space.h"
#include "renderer/compare/compare.h"
#include "renderer/image/image.h"
#include "tests/bench/measure.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

struct Options {
  int size = 256, passes = 64, scenes = 12;
  float distance = 1;  // of the camera, over where it frames the model
  bool paths = false;
  std::string out;
};

struct Place {
  const char* name;
  BuiltinModel model;
  FirstGroom fur;
  std::function<void(SceneSettings&)> change;
};

std::vector<RampStop> plain(glm::vec3 colour) { return {{0, colour}}; }

const std::array<Place, 12>& places() {
  static const auto own = [](SceneSettings&) {};
  static const auto white = [](SceneSettings& s) { s.coat.ramp = plain(glm::vec3(0.9f)); };
  static const auto dark = [](SceneSettings& s) { s.coat.ramp = plain(glm::vec3(0.03f)); };
  static const auto fine = [](SceneSettings& s) {
    s.coat.width_root = 0.0005, s.coat.width_tip = 0.0002, s.coat.count = 20000;
  };
  static const auto curls = [](SceneSettings& s) { s.coat.curl = 0.08, s.coat.curl_together = 0.7; };
  static const auto wet = [](SceneSettings& s) { s.coat.wetness = 0.8; };
  static const auto rim = [](SceneSettings& s) {
    s.lights = {{.kind = LightKind::directional, .direction = {0.3, -0.4, 1}, .intensity = 1.5}};
  };
  static const auto kajiya_kay = [](SceneSettings& s) { s.look.shading = ShadingModel::kajiya_kay; };
  static const std::array<Place, 12> result{
      {{"sphere", {Builtin::sphere, 4000}, {}, own},
       {"sphere, white", {Builtin::sphere, 4000}, {}, white},
       {"sphere, dark", {Builtin::sphere, 4000}, {}, dark},
       {"sphere, fine hair", {Builtin::sphere, 4000}, {}, fine},
       {"sphere, lit from behind", {Builtin::sphere, 4000}, {}, rim},
       {"torus, sleek", {Builtin::torus, 4000}, {.length = 0.02, .inclination = 0.9}, own},
       {"torus, long", {Builtin::torus, 4000}, {.length = 0.06, .inclination = 0.6}, own},
       {"torus, curls", {Builtin::torus, 4000}, {}, curls},
       {"torus, wet", {Builtin::torus, 4000}, {}, wet},
       {"creature", {Builtin::creature, 8000}, {}, own},
       {"creature, white", {Builtin::creature, 8000}, {}, white},
       {"creature, Kajiya-Kay", {Builtin::creature, 8000}, {}, kajiya_kay}}};
  return result;
}

double luminance_of(const FloatImage& image) {
  double light = 0, alpha = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    light += luminance(glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]));
    alpha += image.rgba[i + 3];
  }
  return light / alpha;
}

double coverage_of(const FloatImage& image) {
  double alpha = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha += image.rgba[i];
  return alpha;
}

void save(Renderer& renderer, const FurFrame& frame, const FloatImage& light, const std::string& path) {
  const Result<Image> picture = renderer.finish(frame, light, nullptr);
  if (picture) std::ofstream(path, std::ios::binary) << encode_png(*picture, false);
}

void compare_methods(Renderer& renderer, const Place& place, const Options& options) {
  testing::FurredModel model = testing::furred(place.model, place.fur);
  place.change(model.settings);
  FrameRequest request = testing::small_frame(AutoView::three_quarter, options.size);
  request.tone_map = ToneMap::filmic, request.background = Background::studio;
  request.knobs = knobs_of(Tier::reference);
  request.knobs.trace.passes = options.passes;
  request.knobs.trace.scattering = options.paths ? StrandScattering::energy_conserving : StrandScattering::look;
  if (options.paths) request.knobs.trace.transport = Transport::paths;
  const FloatImage strands = traced_beauty(renderer, model, request, options.distance);
  std::printf("%-24s", place.name);
  for (const Tier tier : {Tier::interactive, Tier::detailed}) {
    request.knobs = knobs_of(tier);
    FurFrame frame = make_frame(model.view(), request);
    frame.camera.position *= options.distance;
    Result<std::vector<FloatImage>> drawn = renderer.draw_aovs(frame, std::array{Aov::beauty});
    if (!drawn) std::exit(4);
    const FloatImage& shells = drawn->front();
    const Result<PictureError> error = compare(strands, shells, union_of(alpha_mask(strands), alpha_mask(shells)));
    std::printf("  coverage %5.3f luminance %5.3f FLIP %.3f", coverage_of(shells) / coverage_of(strands),
                luminance_of(shells) / luminance_of(strands), error && error->figures ? error->figures->flip.mean : -1);
    if (!options.out.empty())
      save(renderer, frame, shells, options.out + "/" + place.name + (tier == Tier::detailed ? " d.png" : " i.png"));
    if (!options.out.empty() && tier == Tier::detailed)
      save(renderer, frame, strands, options.out + "/" + place.name + " s.png");
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
  using namespace pelage::bench;
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--paths")
      options.paths = true;
    else if (name == "--size" && i + 1 < argc)
      options.size = std::atoi(argv[++i]);
    else if (name == "--passes" && i + 1 < argc)
      options.passes = std::atoi(argv[++i]);
    else if (name == "--scenes" && i + 1 < argc)
      options.scenes = std::clamp(std::atoi(argv[++i]), 1, static_cast<int>(places().size()));
    else if (name == "--distance" && i + 1 < argc)
      options.distance = std::strtof(argv[++i], nullptr);
    else if (name == "--out" && i + 1 < argc)
      options.out = argv[++i];
    else
      return std::fprintf(stderr, "unknown option %s\n", name.c_str()), 2;
  }
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  std::printf("shells over strands: interactive, then detailed\n");
  for (const Place& place : std::span(places()).first(static_cast<std::size_t>(options.scenes)))
    compare_methods(*opened.renderer, place, options);
}
