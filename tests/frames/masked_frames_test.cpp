// A frame may show only the fur that the mask leaves to tools.
#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::masked_frames_test {
namespace {

class Masked : public WithRenderer {
 protected:
  /// A ball whose fur is masked on the side of +X, which is on the viewer's right.
  static FurredModel ball() {
    FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.05}));
    const std::vector<glm::vec3>& positions = model.model.surface.mesh().positions;
    for (std::uint32_t v = 0; v < positions.size(); ++v)
      if (positions[v].x > 0) model.fields.set(Field::mask, v, glm::vec4(0));
    return model;
  }
  Image draw_front(const FurredModel& model, bool masked) {
    FrameRequest request = small_frame(AutoView::front, 128);
    request.background = Background::transparent, request.masked = masked;
    return draw(*renderer, model, request);
  }
};

/// Share of the pixels in one half of the picture that show something.
double covered_half(const Image& image, bool right) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = right ? image.width / 2 + 20 : 0; x < (right ? image.width : image.width / 2 - 20); ++x)
      count += image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3] > 127;
  return count / (image.height * (image.width / 2.0 - 20));
}

TEST_F(Masked, WhatIsProtectedIsLeftOutWithItsFur) {
  const FurredModel model = ball();
  const Image whole = draw_front(model, false), half = draw_front(model, true);
  EXPECT_GT(covered_half(whole, true), 0.3);
  EXPECT_EQ(covered_half(half, true), 0);
  EXPECT_NEAR(covered_half(half, false), covered_half(whole, false), 0.02);
  EXPECT_EQ(draw_front(model, false).rgba, whole.rgba);
}

TEST_F(Masked, WithoutAMaskNothingIsHidden) {
  const FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.05}));
  EXPECT_EQ(draw_front(model, true).rgba, draw_front(model, false).rgba);
}

TEST_F(Masked, WhereAllIsProtectedNothingIsDrawn) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.05}));
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) model.fields.set(Field::mask, v, glm::vec4(0));
  EXPECT_EQ(covered(draw_front(model, true)), 0);
  EXPECT_GT(covered(draw_front(model, false)), 0.3);
}

TEST_F(Masked, WhiskersAndEyesGoWithTheirSkin) {
  FurredModel model = ball();
  const Mesh& mesh = model.model.surface.mesh();
  for (const double side : {-1.0, 1.0}) {
    CurveGroup group;
    group.curves = {{mesh.to_model({0.3 * side, 0, 0.3}), mesh.to_model({0.5 * side, 0, 0.5})}};
    model.settings.curves.push_back(group);
    model.settings.eyes.push_back({.position = mesh.to_model({0.3 * side, 0.2, 0.3})});
  }
  FrameRequest request = small_frame();
  const FurFrame all = make_frame(model.view(), request), left = make_frame(model.view(true), request);
  EXPECT_EQ(all.eyes.size(), 2u);
  ASSERT_EQ(left.eyes.size(), 1u);
  EXPECT_EQ(left.eyes.front().position, all.eyes.front().position);
  EXPECT_EQ(left.curves.at(0).guides.size(), 1u);
  EXPECT_TRUE(left.curves.at(1).guides.empty());
}

}  // namespace
}  // namespace pelage::testing::masked_frames_test
