// Shadows of curves on skin, fur and ground.
#include "renderer/frame/renderer.h"
#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::curve_shadow_test {
namespace {

class CurveShadows : public WithRenderer {};

/// A plane with a straight curve over its left half, seen from above; the shadow falls on its right half.
struct CurveOverPlane {
  FurredModel model;
  FrameRequest request = small_frame(AutoView::top, 200);

  explicit CurveOverPlane(double length)
      : model(furred({Builtin::plane, 200}, {.length = length, .inclination = 0.4})) {
    request.knobs.shadow_maps = true;
    model.settings.look.ambient = 0.2;
    model.settings.lights = {{.direction = {1.5, -1, 0}, .cast_shadow = CastShadow::hard}};
  }
  void put(double width, double height = 0.1) {
    const Mesh& mesh = model.model.surface.mesh();
    CurveGroup group;
    group.curves = {{mesh.to_model({-0.17, height, -0.2}), mesh.to_model({-0.07, height, 0.2})}};
    group.width_root = group.width_tip = width;
    model.settings.curves = {group};
  }
  /// What the curve takes from the picture beside itself: the sum over the right half, in 1/255.
  double shadow(Renderer& renderer) {
    const Image with = draw(renderer, model, request);
    std::vector<CurveGroup> kept;
    std::swap(kept, model.settings.curves);
    const Image without = draw(renderer, model, request);
    std::swap(kept, model.settings.curves);
    double sum = 0;
    for (int y = 0; y < with.height; ++y) {
      for (int x = with.width / 2 - 12; x < with.width; ++x) {
        const std::size_t i = 4 * static_cast<std::size_t>(y * with.width + x);
        sum += without.rgba[i + 1] - with.rgba[i + 1];
      }
    }
    return sum;
  }
};

TEST_P(CurveShadows, CurvesCastThemOnSkinAndFur) {
  for (const double length : {0.0, 0.02}) {
    CurveOverPlane scene(length);
    scene.put(0.004);
    EXPECT_GT(scene.shadow(*renderer), 500) << length;
    scene.model.settings.lights[0].cast_shadow = CastShadow::none;
    EXPECT_EQ(scene.shadow(*renderer), 0) << length;
    scene.model.settings.lights[0].cast_shadow = CastShadow::hard;
    scene.request.knobs.shadow_maps = false;
    EXPECT_EQ(scene.shadow(*renderer), 0) << length;
  }
}

TEST_P(CurveShadows, ThatOfACurveThinnerThanATexelFollowsItsWidth) {
  CurveOverPlane scene(0);
  scene.put(0.0016);  // a texel is .0021
  const double wide = scene.shadow(*renderer);
  scene.put(0.0008);
  EXPECT_GT(wide, 200);
  EXPECT_NEAR(scene.shadow(*renderer) / wide, 0.5, 0.1);
  scene.request.knobs.shadow_resolution = 1024;
  EXPECT_NEAR(scene.shadow(*renderer) / wide, 0.5, 0.1);
}

TEST_P(CurveShadows, ThatOfACurveBelowASurfaceIsNotOnIt) {
  CurveOverPlane scene(0);
  scene.put(0.004, -0.1);
  EXPECT_EQ(scene.shadow(*renderer), 0);
}

TEST_P(CurveShadows, ASoftLightThinsThatOfAFarCurve) {
  CurveOverPlane scene(0);
  scene.put(0.002, 0.15);
  const double hard = scene.shadow(*renderer);
  scene.model.settings.lights[0].cast_shadow = CastShadow::soft;
  const double soft = scene.shadow(*renderer);
  EXPECT_GT(soft, 0);
  EXPECT_LT(soft, 0.5 * hard);
}

TEST_P(CurveShadows, CurvesCastThemOnTheGround) {
  FurredModel model = furred({Builtin::sphere, 300}, {.length = 0});
  const Mesh& mesh = model.model.surface.mesh();
  model.settings.ground.visible = true;
  model.settings.lights = {{.direction = {0, -1, 0}, .cast_shadow = CastShadow::hard}};
  FrameRequest request = small_frame(AutoView::top, 160);
  request.camera = {.automatic = AutoView::none,
                    .position = mesh.to_model({1.2, 0.6, 0}),
                    .target = mesh.to_model({0.4, -0.3, 0}),
                    .fov_degrees = 30};
  request.knobs.shadow_maps = true;
  const Image without = draw(*renderer, model, request);
  CurveGroup group;
  group.curves = {{mesh.to_model({0.42, 0.25, -0.2}), mesh.to_model({0.42, 0.25, 0.2})}};
  group.width_root = group.width_tip = 0.006;
  model.settings.curves = {group};
  const Image with = draw(*renderer, model, request);
  double darker = 0;  // alpha of the ground, below the curve itself
  for (std::size_t i = with.rgba.size() / 2 + 3; i < with.rgba.size(); i += 4) darker += with.rgba[i] - without.rgba[i];
  EXPECT_GT(darker, 500);
}

INSTANTIATE_TEST_SUITE_P(Gl, CurveShadows, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::curve_shadow_test
