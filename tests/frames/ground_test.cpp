// A ground that catches shadows: what it darkens is its opacity over a transparent background.
#include <cmath>

#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::ground_test {
namespace {

/// Opacity that the ground adds to the picture, in 1/255: the sum over all pixels, and over the left and right half.
struct Darkening {
  double sum = 0, left = 0, right = 0;
};

class Grounds : public WithRenderer {
 protected:
  Image picture() { return draw(*renderer, model, small_frame(AutoView::three_quarter)); }
  Darkening darkening() {
    const Ground asked = model.settings.ground;
    model.settings.ground = {};
    const Image without = picture();
    model.settings.ground = asked;
    const Image with = picture();
    Darkening found;
    for (std::size_t i = 3; i < with.rgba.size(); i += 4) {
      const double more = with.rgba[i] - without.rgba[i];
      found.sum += more;
      (static_cast<int>(i / 4) % with.width < with.width / 2 ? found.left : found.right) += more;
    }
    return found;
  }
  void light_along(glm::dvec3 direction) {
    model.settings.look.ambient = 0.1;
    model.settings.lights = {{.direction = direction, .cast_shadow = CastShadow::hard}};
  }

  FurredModel model = coarse(furred({Builtin::sphere, 500}, {.length = 0.02}));
};

TEST_F(Grounds, CatchNothingUnlessAsked) {
  const Image before = picture();
  model.settings.ground = {.visible = true, .height = {}, .shadow = 0, .contact = 0};
  EXPECT_EQ(picture().rgba, before.rgba);
  model.settings.ground = {.visible = true, .height = {}, .shadow = 1, .contact = 1};
  EXPECT_NE(picture().rgba, before.rgba);
  model.settings.ground.visible = false;
  EXPECT_EQ(picture().rgba, before.rgba);
}

TEST_F(Grounds, DarkenWhereTheModelIsNear) {
  model.settings.ground = {.visible = true, .height = {}, .shadow = 0, .contact = 0.4};
  const double some = darkening().sum;
  EXPECT_GT(some, 2000);
  model.settings.ground.contact = 0.8;
  EXPECT_NEAR(darkening().sum, 2 * some, 0.1 * some);
  const Mesh& mesh = model.model.surface.mesh();
  model.settings.ground.height = mesh.to_model({0, -0.6, 0}).y;  // the lowest point is at -.289
  EXPECT_LT(darkening().sum, some);
}

TEST_F(Grounds, ShadowsFallAwayFromTheLight) {
  model.settings.ground = {.visible = true, .height = {}, .shadow = 1, .contact = 0};
  const FurFrame frame = make_frame(model.view(), small_frame(AutoView::three_quarter));
  const glm::dvec3 right(frame.camera.right);
  light_along(glm::dvec3(right.x, -1, right.z));
  const Darkening to_the_right = darkening();
  EXPECT_GT(to_the_right.right, 5 * to_the_right.left);
  EXPECT_GT(to_the_right.right, 10000);
  light_along(glm::dvec3(-right.x, -1, -right.z));
  const Darkening to_the_left = darkening();
  EXPECT_GT(to_the_left.left, 5 * to_the_left.right);
  model.settings.ground.shadow = 0.5;
  EXPECT_NEAR(darkening().left, 0.5 * to_the_left.left, 0.1 * to_the_left.left);
}

/// A light that points away from the ground casts no shadow on it, however near it is.
TEST_F(Grounds, LightsThatShineElsewhereCastNoShadow) {
  model.settings.ground = {.visible = true, .height = {}, .shadow = 1, .contact = 0};
  model.settings.look.ambient = 0.1;
  const glm::dvec3 above = model.model.surface.mesh().to_model({0, 1.2, 0});
  for (const LightKind kind : {LightKind::spot, LightKind::area}) {
    model.settings.lights = {{.kind = kind,
                              .direction = {0, -1, 0},
                              .position = above,
                              .cone_degrees = 60,
                              .cast_shadow = CastShadow::hard}};
    EXPECT_GT(darkening().sum, 2000) << int(kind);
    model.settings.lights[0].direction = {0, 1, 0};
    EXPECT_EQ(darkening().sum, 0) << int(kind);
  }
}

}  // namespace
}  // namespace pelage::testing::ground_test
