// Whiskers, lashes and brows in whole frames.
#include <algorithm>
#include <cmath>

#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::curves_test {
namespace {

/// A straight curve between points in internal coordinates, where the sphere's radius is .289. The camera is on +Z.
CurveGroup line(const FurredModel& model, glm::dvec3 from, glm::dvec3 to, double width = 0.01) {
  const Mesh& mesh = model.model.surface.mesh();
  CurveGroup group;
  group.curves = {{mesh.to_model(from), mesh.to_model(to)}};
  group.width_root = group.width_tip = width;
  return group;
}

class Curves : public WithRenderer {
 protected:
  /// Mean difference that the curve groups make to a picture of the model, in 1/255.
  double change(FurredModel& model, std::vector<CurveGroup> groups, const FrameRequest& request = small_frame()) {
    model.settings.curves.clear();
    const Image without = draw(*renderer, model, request);
    model.settings.curves = std::move(groups);
    return mean_difference(without, draw(*renderer, model, request));
  }
};

TEST_F(Curves, LeaveNoTraceInFramesWithoutThem) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}));
  const Image before = draw(*renderer, model, small_frame());
  model.settings.curves = {line(model, {0.28, 0, 0}, {0.45, 0.05, 0})};
  EXPECT_NE(draw(*renderer, model, small_frame()).rgba, before.rgba);
  model.settings.curves.clear();
  EXPECT_EQ(draw(*renderer, model, small_frame()).rgba, before.rgba);
}

TEST_F(Curves, AreSeenBesideTheBodyAndHiddenBehindIt) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.03}));
  const double beside = change(model, {line(model, {0.30, 0, 0}, {0.42, 0, 0})});
  EXPECT_GT(beside, 0.1);
  EXPECT_GT(change(model, {line(model, {-0.1, 0, 0.40}, {0.1, 0, 0.40})}), 0.1);  // in front
  EXPECT_EQ(change(model, {line(model, {-0.1, 0, -0.40}, {0.1, 0, -0.40})}), 0);  // behind
  EXPECT_EQ(change(model, {line(model, {-0.1, 0, 0}, {0.1, 0, 0})}), 0);          // inside
}

TEST_F(Curves, AnEyeHidesThem) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0}));
  model.settings.eyes = {{.position = model.model.surface.mesh().to_model({0, 0, 0.3}), .radius = 0.1}};
  EXPECT_EQ(change(model, {line(model, {-0.03, 0, 0.36}, {0.03, 0, 0.36})}), 0);  // inside the eyeball
  EXPECT_GT(change(model, {line(model, {-0.03, 0, 0.42}, {0.03, 0, 0.42})}), 0.02);
}

TEST_F(Curves, FurCoversTheirRoots) {
  // The curve lies on the skin, with and without fur.
  FurredModel bare = coarse(furred({Builtin::sphere, 1000}, {.length = 0}));
  FurredModel furry = coarse(furred({Builtin::sphere, 1000}, {.length = 0.08, .inclination = 0.3}));
  // It lies above the source of the first groom's flow: fur stands up there, and the camera looks down to its roots.
  const auto on_skin = [&](const FurredModel& model) {
    return line(model, {-0.02, 0.16, 0.2435}, {0.02, 0.16, 0.2435});
  };
  const double naked = change(bare, {on_skin(bare)});
  EXPECT_GT(naked, 0.02);
  EXPECT_LT(change(furry, {on_skin(furry)}), 0.1 * naked);
}

TEST_F(Curves, CoverageFollowsTheWidthBelowAPixel) {
  FurredModel model = coarse(furred({Builtin::sphere, 300}, {.length = 0}));
  const auto alpha = [&](double width) {
    model.settings.curves = {line(model, {0.32, -0.1, 0}, {0.32, 0.1, 0}, width)};
    const Image image = draw(*renderer, model, small_frame());
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 3 * image.width / 4; x < image.width; ++x)
        sum += image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3];
    }
    return sum;
  };
  const double nothing = alpha(0), thin = alpha(0.0005), twice = alpha(0.001);
  EXPECT_GT(thin - nothing, 100);
  EXPECT_NEAR((twice - nothing) / (thin - nothing), 2, 0.1);
}

TEST_F(Curves, EveryShadingModelShowsThem) {
  FurredModel model = coarse(furred({Builtin::sphere, 300}));
  for (int shading = 0; shading <= static_cast<int>(ShadingModel::marschner); ++shading) {
    model.settings.look.shading = static_cast<ShadingModel>(shading);
    EXPECT_GT(change(model, {line(model, {0.30, 0, 0}, {0.42, 0, 0})}), 0.1) << shading;
  }
}

TEST_F(Curves, ExtremesGiveFinitePictures) {
  FurredModel model = coarse(furred({Builtin::sphere, 300}));
  const Mesh& mesh = model.model.surface.mesh();
  FrameRequest request = small_frame(AutoView::front, 24);
  request.background = Background::colour;
  for (const double far : {0.0, 1e-9, 1.0, 1e6}) {
    for (const double width : {0.0, 0.1}) {
      CurveGroup group = line(model, {0, 0, 0.3}, {far, -far, 0.3 + far}, width);
      group.curves.push_back({mesh.to_model({0, 0, 0.4}), mesh.to_model({0, 0, 0.4})});
      group.fill = 5, group.spread = 1;
      model.settings.curves = {group};
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
    }
  }
}

TEST_F(Curves, SameFrameSameBits) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}));
  CurveGroup group = line(model, {0.28, 0, 0}, {0.45, 0.05, 0});
  group.curves.push_back(line(model, {0.28, 0.1, 0}, {0.4, 0.2, 0}).curves[0]);
  group.fill = 30, group.spread = 1;
  model.settings.curves = {group};
  const Image first = draw(*renderer, model, small_frame());
  model.settings.curves[0].seed = 2;
  EXPECT_NE(first.rgba, draw(*renderer, model, small_frame()).rgba);
  model.settings.curves[0].seed = 1;
  EXPECT_EQ(first.rgba, draw(*renderer, model, small_frame()).rgba);
}

}  // namespace
}  // namespace pelage::testing::curves_test
