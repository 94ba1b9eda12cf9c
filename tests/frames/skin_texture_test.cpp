// A skin texture replaces the model's own colours, which return when it is taken off.
#include "server/builtin/builtin.h"
#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"
#include "tests/support/textured.h"

namespace pelage::testing::skin_texture_test {
namespace {

class Backplate : public WithRenderer {
 protected:
  /// A ball with UVs, under white light from all directions.
  static FurredModel ball() {
    FurredModel model = coarse(furred(with_planar_uvs(make_builtin({Builtin::sphere, 1000}))));
    model.settings.lights.clear();
    model.settings.look.ambient = 1;
    return model;
  }
  Image draw_front(const FurredModel& model) { return draw(*renderer, model, small_frame(AutoView::front, 128)); }
};

/// Mean colour of a block of pixels on one side of the middle.
glm::dvec3 colour_beside(const Image& image, bool right) {
  glm::dvec3 sum(0);
  int count = 0;
  for (int row = 54; row < 74; ++row) {
    for (int column = right ? 80 : 32; column < (right ? 96 : 48); ++column, ++count) {
      const std::size_t at = 4 * static_cast<std::size_t>(row * image.width + column);
      sum += glm::dvec3(image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]);
    }
  }
  return sum / double(count);
}

TEST_F(Backplate, LiesWhereTheTextureCoordinatesSay) {
  FurredModel model = ball();
  model.skin_texture = red_and_blue();
  model.settings.skin_texture = std::string(32, 'a');
  const Image image = draw_front(model);
  const glm::dvec3 left = colour_beside(image, false), right = colour_beside(image, true);
  EXPECT_GT(left.x, left.z + 60);
  EXPECT_GT(right.z, right.x + 60);
}

TEST_F(Backplate, RowsCountFromTheTop) {
  FurredModel model = ball();
  model.skin_texture = RawImage{1, 2, {255, 0, 0, 255, 0, 0, 255, 255}};  // red over blue
  model.settings.skin_texture = std::string(32, 'a');
  const Image image = draw_front(model);
  const auto at = [&](int row) { return 4 * static_cast<std::size_t>(row * image.width + image.width / 2); };
  EXPECT_GT(image.rgba[at(40)], image.rgba[at(40) + 2] + 60);
  EXPECT_GT(image.rgba[at(88) + 2], image.rgba[at(88)] + 60);
}

TEST_F(Backplate, TakingItOffGivesTheSamePictureAsBefore) {
  FurredModel model = ball();
  const Image before = draw_front(model);
  model.skin_texture = red_and_blue();
  model.settings.skin_texture = std::string(32, 'a');
  const Image with = draw_front(model);
  EXPECT_GT(mean_difference(before, with), 3);
  model.skin_texture = RawImage{1, 1, {0, 255, 0, 255}};
  model.settings.skin_texture = std::string(32, 'b');
  const Image green = draw_front(model);
  EXPECT_GT(mean_colour(green).y, mean_colour(green).x + 60);
  model.skin_texture.reset();
  model.settings.skin_texture.clear();
  EXPECT_EQ(draw_front(model).rgba, before.rgba);
}

TEST_F(Backplate, OneCopyOfAModelIsCached) {
  FurredModel model = ball();
  draw_front(model);
  model.skin_texture = red_and_blue();
  model.settings.skin_texture = std::string(32, 'a');
  draw_front(model);
  EXPECT_FALSE(renderer->has(model.model.id));
  renderer->forget(model.model.id);
  EXPECT_GT(sync_scene(*renderer, model.view(), {}).bytes, 10'000u) << "forgotten, so all of it is sent again";
}

}  // namespace
}  // namespace pelage::testing::skin_texture_test
