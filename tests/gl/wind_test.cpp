// Fur in the wind: all drawers show the same motion, and still and moved frames leave each other alone.
#include "renderer/marched/marcher.h"
#include "server/frames/fur_view.h"
#include "server/frames/moved_fur.h"
#include "tests/gl/flip.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::wind_test {
namespace {

class InTheWind : public WithRenderer {
 protected:
  static constexpr FirstGroom ball{.length = 0.08, .inclination = 0.2};
  static FurredModel blown_ball() {
    FurredModel model = furred({Builtin::sphere, 1500}, ball);
    model.settings.wind = {.speed = 0.6, .direction = {1, 0.4, 0}, .turbulence_scale = 0.2};
    return model;
  }

  FurFrame sync(Renderer& drawer, const FurredModel& model, std::optional<double> time) {
    request.time = time;
    const SceneView view = model.view();
    const MovedFur::Shown shown = fur.show(view, moment_of(view, request));
    std::vector<VertexRange> dirty;
    if (shown.whole) dirty.push_back({0, static_cast<std::uint32_t>(model.fields.size())});
    sync_scene(drawer, view, dirty, shown.direction.get());
    return make_frame(view, request);
  }
  Image at(Renderer& drawer, const FurredModel& model, std::optional<double> time) {
    return drawer.draw(sync(drawer, model, time)).value();
  }

  MovedFur fur;
  FrameRequest request = small_frame(AutoView::front, 160);
};

TEST_P(InTheWind, AMomentHasTheSameBitsWhateverWasDrawnBefore) {
  FurredModel model = blown_ball();
  const Image first = at(*renderer, model, 2), other = at(*renderer, model, 5);
  EXPECT_GT(mean_difference(first, other), 0.5);
  EXPECT_EQ(largest_difference(at(*renderer, model, 2), first), 0);
  model.settings.wind.speed = 0;
  const Image still = at(*renderer, model, 2);
  EXPECT_GT(mean_difference(still, first), 0.5);
  EXPECT_EQ(largest_difference(still, draw(*renderer, furred({Builtin::sphere, 1500}, ball), request)), 0);
  model.settings.wind.speed = 0.6;
  EXPECT_EQ(largest_difference(at(*renderer, model, 2), first), 0);
}

TEST_P(InTheWind, ShellsOfTheGlAndMarchedOnesAgree) {
  const FurredModel model = blown_ball();
  request.knobs.shells = 32, request.knobs.order = FragmentOrder::sorted;
  for (const double time : {1.0, 3.5}) {
    const Image shells = at(*renderer, model, time);
    const FurFrame frame = make_frame(model.view(), request);
    const MovedDirection moved = moved_at(model.view(), time);
    const auto marched = [&](const std::vector<glm::vec2>* direction) {
      Marcher marcher(2);
      const ModelArrays arrays = make_arrays(model.view());
      marcher.add(make_model(model.view(), arrays), make_fields(model.view(), frame.skin, {}, direction));
      return renderer->finish(frame, marcher.draw(frame, {32, 0, 1, 64})).value();
    };
    const double apart = flip_between(shells, marched(moved.get()));
    EXPECT_LT(apart, 0.05);
    EXPECT_GT(flip_between(shells, marched(nullptr)), 1.5 * apart) << "and fur at rest does not";
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, InTheWind, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::wind_test
