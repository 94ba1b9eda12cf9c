// Shadows from maps: they darken what lies behind, agree with the estimate where both are right, and are kept.
#include <cmath>

#include "renderer/frame/renderer.h"
#include "server/scene/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

class Shadows : public WithRenderer {
 protected:
  /// Light from above, the picture from above too, so that what is shadowed by itself is not seen.
  Image picture(FurredModel& model, const Light& light, bool maps, AutoView from = AutoView::top) {
    model.settings.lights = {light};
    FrameRequest request = small_frame(from, 160);
    request.knobs.shadow_maps = maps;
    return draw(*renderer, model, request);
  }
  static double mean(const Image& image) {
    const glm::dvec3 colour = mean_colour(image);
    return (colour.r + colour.g + colour.b) / 3;
  }
};

const Light from_above{.direction = {0, -1, 0}, .intensity = 1};

TEST_P(Shadows, LayerMapsAgreeWithTheEstimateOnAPlane) {
  // Upright fur seen along the light: the map holds what the strands above let through, the estimate their mean.
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.05, .inclination = 0.6});
  Light light = from_above;
  const double estimate = mean(picture(model, light, false));
  light.self_shadow_maps = true;
  const double maps = mean(picture(model, light, true));
  EXPECT_NEAR(maps, estimate, 0.15 * estimate);
  model.settings.look.self_shadow = 0;
  EXPECT_GT(mean(picture(model, light, false)), estimate * 1.05);  // so there is a shadow to agree on
}

TEST_P(Shadows, CastShadowOnlyDarkens) {
  FurredModel model = furred({Builtin::knot, 2000}, {.length = 0.01});
  model.settings.look.ambient = 0.2;  // so that the means are the lamp's
  Light light = from_above;
  const Image open = picture(model, light, true, AutoView::front);
  light.cast_shadow = CastShadow::hard;
  const Image hard = picture(model, light, true, AutoView::front);
  light.cast_shadow = CastShadow::soft;
  const Image soft = picture(model, light, true, AutoView::front);
  for (std::size_t i = 0; i < open.rgba.size(); ++i) {
    ASSERT_LE(hard.rgba[i], open.rgba[i] + 1);
    ASSERT_LE(hard.rgba[i], soft.rgba[i] + 1);
    ASSERT_LE(soft.rgba[i], open.rgba[i] + 1);
  }
  EXPECT_LT(mean(hard), 0.95 * mean(open));
  EXPECT_LT(mean(soft), 0.97 * mean(open));
  EXPECT_GT(mean(soft), 1.002 * mean(hard));
}

TEST_P(Shadows, KnobAndLightMustBothAsk) {
  FurredModel model = furred({Builtin::knot, 1000});
  Light light = from_above;
  const Image plain = picture(model, light, true);
  light.cast_shadow = CastShadow::hard, light.self_shadow_maps = true;
  EXPECT_EQ(picture(model, light, false).rgba, plain.rgba);
  EXPECT_NE(picture(model, light, true).rgba, plain.rgba);
}

TEST_P(Shadows, MapsAreKeptUntilFieldsOrLightChange) {
  FurredModel model = furred({Builtin::sphere, 300});
  Light light = from_above;
  light.self_shadow_maps = true;
  picture(model, light, true);
  FrameRequest request = small_frame(AutoView::left);
  request.knobs.shadow_maps = true;
  const auto made = [&] {
    DrawTimes times;
    EXPECT_TRUE(renderer->draw(make_frame(model.view(), request), &times).ok());
    return times.shadow > 0;
  };
  EXPECT_FALSE(made());  // another view of the same
  model.settings.lights[0].direction = {1, -1, 0};
  EXPECT_TRUE(made());
  EXPECT_FALSE(made());
  model.fields.set(5, {{0.5f, 0}, 0.05f, 0});
  sync_scene(*renderer, model.view(), {{5, 6}});
  EXPECT_TRUE(made());
}

TEST_P(Shadows, LightsInsideTheModelAndTinyMapsAreFine) {
  FurredModel model = furred({Builtin::sphere, 300});
  for (const glm::dvec3 position : {glm::dvec3(0), glm::dvec3(0.4, 0, 0), glm::dvec3(0, 1e6, 0)}) {
    for (const LightKind kind : {LightKind::point, LightKind::spot}) {
      model.settings.lights = {{.kind = kind,
                                .position = position,
                                .intensity = 1e8,
                                .self_shadow_maps = true,
                                .cast_shadow = CastShadow::soft}};
      FrameRequest request = small_frame(AutoView::front, 24);
      request.knobs.shadow_maps = true;
      request.knobs.shadow_resolution = 1;
      request.background = Background::colour;
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
    }
  }
}

TEST_P(Shadows, ASpotLightsOnlyItsCone) {
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.02, .inclination = 0.8});
  model.settings.look.ambient = 0;
  Light light{.kind = LightKind::spot, .direction = {0, -1, 0}, .position = {0, 1, 0}, .intensity = 1};
  const double full = mean(picture(model, {.kind = LightKind::point, .position = {0, 1, 0}}, false));
  light.cone_degrees = 80;
  EXPECT_NEAR(mean(picture(model, light, false)), full, 0.02 * full);
  light.cone_degrees = 10;
  EXPECT_LT(mean(picture(model, light, false)), 0.5 * full);
}

INSTANTIATE_TEST_SUITE_P(Gl, Shadows, all_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
