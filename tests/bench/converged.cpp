// How the picture of sorted fragments converges, and what sorting does: FLIP and relMSE between shells of doubling
// number, of the creature from two sides and of its ear in front of the flank.
// usage: bench_converged [--size PIXELS] [--most SHELLS]
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "renderer/compare/compare.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

struct View {
  const char* name;
  Camera camera;
  double length, inclination;  // of the fur
};

struct Picture {
  FloatImage light;
  double megafragments = 0, seconds = 0;
};

/// The ear as docs/gallery/figures.py has it.
std::array<View, 3> views() {
  Camera front, back, ear;
  front.automatic = AutoView::three_quarter, back.automatic = AutoView::back;
  ear.automatic = AutoView::none;
  ear.position = {-0.35, 2.3, 1.9}, ear.target = {0.05, 0.9, 0.12}, ear.fov_degrees = 17;
  return {{{"three quarter", front, 0.03, 0.45}, {"back", back, 0.03, 0.45}, {"ear before flank", ear, 0.04, 0.6}}};
}

FurFrame frame_of(const testing::FurredModel& model, const View& view, int size, int shells, FragmentOrder order) {
  FrameRequest request = testing::small_frame(AutoView::front, size);
  request.tone_map = ToneMap::filmic;
  request.camera = view.camera;
  request.knobs.order = order;
  request.knobs.shells = shells;
  request.knobs.shell_policy = ShellPolicy::uniform;
  return make_frame(model.view(), request);
}

Picture picture_of(Renderer& renderer, const FurFrame& frame) {
  Picture picture;
  DrawTimes times;
  const Cost cost = measure([&] {
    Result<std::vector<FloatImage>> light = renderer.draw_aovs(frame, std::array{Aov::beauty}, &times);
    if (!light) std::fprintf(stderr, "%s\n", light.status().message.c_str()), std::exit(4);
    picture.light = std::move(light.value().front());
  });
  picture.megafragments = static_cast<double>(times.counters.fragments) / 1e6;
  picture.seconds = cost.cpu / 1e3;
  return picture;
}

void print(const std::string& name, const Picture& truth, const Picture& picture) {
  const Mask mask = union_of(alpha_mask(truth.light), alpha_mask(picture.light));
  const Result<PictureError> error = compare(truth.light, picture.light, mask);
  if (!error || !error->figures) std::fprintf(stderr, "the pictures cannot be compared\n"), std::exit(4);
  const PictureFigures& f = *error->figures;
  std::printf("  %-20s FLIP %.5f, 95th %.4f, silhouette %.5f; relMSE %.2e, bias %+.2e; %8.2f Mfragments, %7.1f s CPU\n",
              name.c_str(), f.flip.mean, f.flip.percentile_95, f.silhouette.value_or(FlipFigures{}).mean, f.rel_mse,
              f.bias, picture.megafragments, picture.seconds);
  std::fflush(stdout);
}

void run(Renderer& renderer, const View& view, int size, int max) {
  const testing::FurredModel model =
      testing::furred({Builtin::creature, 5000}, {.length = view.length, .inclination = view.inclination});
  testing::draw(renderer, model, testing::small_frame());
  std::printf("\n%s\n", view.name);
  const auto draw = [&](int shells, FragmentOrder order) {
    return picture_of(renderer, frame_of(model, view, size, shells, order));
  };
  Picture truth = draw(64, FragmentOrder::sorted);
  for (int shells = 128; shells <= max; shells *= 2) {
    Picture next = draw(shells, FragmentOrder::sorted);
    print(std::to_string(shells / 2) + " by " + std::to_string(shells), next, truth);
    truth = std::move(next);
  }
  for (const int shells : {16, 64, 256}) {
    const std::string against = std::to_string(shells) + " by " + std::to_string(max);
    print(against + " shells", truth, draw(shells, FragmentOrder::shells));
    print(against + " sorted", truth, draw(shells, FragmentOrder::sorted));
  }
  renderer.forget(model.model.id);
}

int main(int count, char** arguments) {
  const int size = argument(count, arguments, "--size", 512), max = argument(count, arguments, "--most", 1024);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  for (const View& view : views()) run(*opened.renderer, view, size, max);
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
