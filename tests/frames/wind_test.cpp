// Fur in the wind: still and moved frames do not affect each other.
#include "server/frames/shown_fur.h"
#include "server/frames/shown_scene.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::wind_test {
namespace {

class InTheWind : public WithRenderer {
 protected:
  static constexpr FirstGroom ball{.length = 0.08, .inclination = 0.2};
  static FurredModel blown_ball() {
    FurredModel model = coarse(furred({Builtin::sphere, 1500}, ball));
    model.settings.wind = {.speed = 0.6, .direction = {1, 0.4, 0}, .turbulence_scale = 0.2};
    return model;
  }

  FurFrame sync(Renderer& drawer, const FurredModel& model, std::optional<double> time) {
    request.time = time;
    const std::shared_ptr<const void> nobody;  // no owner is needed: the model outlives the snapshot
    return sync_snapshot(drawer, fur,
                         std::make_shared<const SceneSnapshot>(SceneSnapshot{.model = {nobody, &model.model},
                                                                             .fields = {nobody, &model.fields},
                                                                             .settings = {nobody, &model.settings},
                                                                             .copy_id = model.model.id}),
                         request)
        .fur;
  }
  Image at(Renderer& drawer, const FurredModel& model, std::optional<double> time) {
    return drawer.draw(sync(drawer, model, time)).value();
  }

  RendererCopyStates fur;
  FrameRequest request = small_frame(AutoView::front, 160);
};

TEST_F(InTheWind, AMomentHasTheSameBitsWhateverWasDrawnBefore) {
  FurredModel model = blown_ball();
  const Image first = at(*renderer, model, 2), other = at(*renderer, model, 5);
  EXPECT_GT(mean_difference(first, other), 0.5);
  EXPECT_EQ(largest_difference(at(*renderer, model, 2), first), 0);
  model.settings.wind.speed = 0;
  const Image still = at(*renderer, model, 2);
  EXPECT_GT(mean_difference(still, first), 0.5);
  EXPECT_EQ(largest_difference(still, draw(*renderer, coarse(furred({Builtin::sphere, 1500}, ball)), request)), 0);
  model.settings.wind.speed = 0.6;
  EXPECT_EQ(largest_difference(at(*renderer, model, 2), first), 0);
}

}  // namespace
}  // namespace pelage::testing::wind_test
