// How the picture of sorted fragments converges, and what sorting does: FLIP and relMSE between shells of doubling
// number, of the creature from two sides and of its ear in front of the flank.
// usage: bench_converged [--size PIXELS] [--most SHELLS]
#include <array>
#include <chrono>
#include <cstdio>

#include "renderer/compare/compare.h"
#include "renderer/image/float_image.h"
#include "server/scene/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

struct View {
  const char* name;
  Camera camera;
  double length, inclination;  // of the fur
};

struct Picture {
  Image shown;       // with the tone map, for FLIP
  FloatImage light;  // for relMSE
  double megafragments = 0, seconds = 0;
};

/// The ear as docs/gallery/figures.py has it.
std::array<View, 3> views() {
  Camera front, back, ear;
  front.automatic = AutoView::three_quarter, back.automatic = AutoView::back;
  ear.automatic = AutoView::none;
  ear.eye = {-0.35, 2.3, 1.9}, ear.target = {0.05, 0.9, 0.12}, ear.fov_degrees = 17;
  return {{{"three quarter", front, 0.03, 0.6}, {"back", back, 0.03, 0.6}, {"ear before flank", ear, 0.04, 0.6}}};
}

FurFrame frame_of(const testing::FurredModel& model, const View& view, int size, int shells, FragmentOrder order) {
  FrameRequest request = testing::small_frame(AutoView::front, size);
  request.tone_map = ToneMap::filmic;
  request.camera = view.camera;
  request.knobs.order = order;
  request.knobs.shells = shells;
  request.knobs.shell_policy = ShellPolicy::uniform;
  request.knobs.accumulation = Accumulation::full;
  return make_frame(model.view(), request);
}

Picture picture_of(Renderer& renderer, const FurFrame& frame) {
  Picture picture;
  DrawTimes times;
  const Cost cost = measure([&] { picture.shown = draw(renderer, frame, &times); });
  Result<std::vector<FloatImage>> light = renderer.draw_layers(frame, std::array{FrameLayer::beauty});
  if (!light) std::fprintf(stderr, "%s\n", light.status().message.c_str()), std::exit(4);
  picture.light = std::move(light.value().front());
  picture.megafragments = static_cast<double>(times.counters.fragments) / 1e6;
  picture.seconds = cost.cpu / 1e3;
  return picture;
}

void compare_rows(const char* name, const Picture& truth, const Picture& picture) {
  const Mask mask = union_of(alpha_mask(linear_image(truth.shown)), alpha_mask(linear_image(picture.shown)));
  const Result<PictureError> shown = compare(truth.shown, picture.shown, mask);
  const Result<PictureError> light = compare(truth.light, picture.light, mask);
  if (!shown || !shown->figures || !light || !light->figures) {
    std::fprintf(stderr, "the pictures cannot be compared\n"), std::exit(4);
  }
  const PictureFigures &f = *shown->figures, &l = *light->figures;
  std::printf("  %-28s FLIP %.5f, 95th %.4f, outline %.5f; relMSE %.2e, bias %+.2e; %8.2f Mfragments, %7.1f s CPU\n", name, f.flip.mean,
              f.flip.high, f.outline.value_or(FlipFigures{}).mean, l.relative_mse, l.bias, picture.megafragments, picture.seconds);
  std::fflush(stdout);
}

void run(Renderer& renderer, const View& view, int size, int most) {
  const testing::FurredModel model = testing::furred({Builtin::creature, 5000}, {.length = view.length, .inclination = view.inclination});
  testing::draw(renderer, model, testing::small_frame());
  std::printf("\n%s\n", view.name);
  Picture before;
  for (int shells = 64; shells <= most; shells *= 2) {
    Picture next = picture_of(renderer, frame_of(model, view, size, shells, FragmentOrder::sorted));
    if (shells > 64) compare_rows(("sorted, " + std::to_string(shells / 2) + " to " + std::to_string(shells)).c_str(), before, next);
    before = std::move(next);
  }
  for (int shells = 16; shells <= 256; shells *= 4) {
    compare_rows(("layers, " + std::to_string(shells) + " to most sorted").c_str(), before,
                 picture_of(renderer, frame_of(model, view, size, shells, FragmentOrder::layers)));
    compare_rows(("sorted, " + std::to_string(shells) + " to most sorted").c_str(), before,
                 picture_of(renderer, frame_of(model, view, size, shells, FragmentOrder::sorted)));
  }
  renderer.forget(model.model.id);
}

int main(int count, char** arguments) {
  const int size = argument(count, arguments, "--size", 512), most = argument(count, arguments, "--most", 1024);
  const BenchRenderer opened = open_renderer();
  if (!opened.renderer) return 4;
  for (const View& view : views()) run(*opened.renderer, view, size, most);
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
