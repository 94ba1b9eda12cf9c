// Fur at a fold of the skin, where it grows into the body.
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::folded_skin_test {
namespace {

/// A front-facing triangle, and on each of its edges one ten times as large, folded back below it: the normals of its
/// vertices point away from the front, and its fur with them.
FurredModel folded() {
  RawModel raw;
  raw.positions = {{-1, -0.6, 0}, {1, -0.6, 0}, {0, 1, 0}, {0, 16, -0.5}, {-14, -7, -0.6}, {14, -7, -0.7}};
  raw.corners = {0, 1, 2, 1, 0, 3, 2, 1, 4, 0, 2, 5};
  raw.face_sizes.assign(4, 3);
  FurredModel model = furred(raw, {.length = 0.02, .inclination = 0});
  model.settings.look.specular = 0;
  return model;
}

class FoldedSkin : public WithRenderer {
 protected:
  double middle(const FurredModel& model, bool self_shadow) {
    FrameRequest request = shells_frame();
    request.camera = {.automatic = AutoView::none, .position = {0, 0, 10}};
    request.knobs.shells.self_shadow = self_shadow;
    const Image image = draw(*renderer, model, request);
    return image.rgba[4 * static_cast<std::size_t>(image.height / 2 * image.width + image.width / 2)];
  }
};

TEST_P(FoldedSkin, IsNotShadedByFurThatGrowsIntoIt) {
  const FurredModel model = folded();
  const double unshadowed = middle(model, false);
  EXPECT_GT(unshadowed, 20);
  EXPECT_GT(middle(model, true), 0.9 * unshadowed);
}

INSTANTIATE_TEST_SUITE_P(Gl, FoldedSkin, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::folded_skin_test
