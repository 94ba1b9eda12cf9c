// Bare skin in whole frames.
#include <algorithm>
#include <cmath>

#include "renderer/upload/blocks.h"
#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::bare_skin_test {
namespace {

class BareSkinFrames : public WithRenderer {
 protected:
  Image drawn(const FurredModel& model) { return draw(*renderer, model, small_frame()); }
};

FurredModel ball(double fur = 0.08) {
  return coarse(furred({Builtin::sphere, 2000}, {.length = fur, .inclination = 0}));
}

/// A skin region that covers the whole model, evenly blue and matt.
SkinRegion everywhere(const FurredModel& model) {
  SkinRegion region{.centre = model.model.surface.mesh().centre, .radii = glm::dvec3(2), .colour = {0, 0, 0.5f}};
  region.shine = 0, region.scatter = 0;
  region.bumps.height = 0;
  return region;
}

glm::ivec3 middle_of(const Image& image) {
  const std::size_t i = 4 * static_cast<std::size_t>(image.height / 2 * image.width + image.width / 2);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

TEST_F(BareSkinFrames, HasNoFurAndTheRegionsColour) {
  FurredModel model = ball();
  const double furry = covered(drawn(model));
  const double skin = covered(drawn(ball(0)));
  model.settings.skin = {everywhere(model)};
  const Image bare = drawn(model);
  EXPECT_GT(furry, 1.2 * skin);
  EXPECT_NEAR(covered(bare), skin, 1e-3);
  for (std::size_t i = 0; i < bare.rgba.size(); i += 4) {
    if (bare.rgba[i + 3] < 255) continue;
    ASSERT_EQ(bare.rgba[i], 0) << "fur, or the colour of the skin below it, shows through";
    ASSERT_EQ(bare.rgba[i + 1], 0);
  }
  EXPECT_GT(middle_of(bare).z, 40);
}

TEST_F(BareSkinFrames, LeavesNoTraceWhenItIsTakenAway) {
  FurredModel model = ball();
  const Image before = drawn(model);
  model.settings.skin = {everywhere(model)};
  EXPECT_NE(drawn(model).rgba, before.rgba);
  model.settings.skin.clear();
  EXPECT_EQ(drawn(model).rgba, before.rgba);
  renderer->forget(model.model.id);
  EXPECT_EQ(drawn(model).rgba, before.rgba);
}

TEST_F(BareSkinFrames, FarFromTheModelChangesNothing) {
  FurredModel model = ball();
  const Image before = drawn(model);
  model.settings.skin = {everywhere(model)};
  model.settings.skin[0].centre += 100.0;
  EXPECT_EQ(drawn(model).rgba, before.rgba);
}

TEST_F(BareSkinFrames, LaterRegionsLieOverEarlierOnes) {
  FurredModel model = ball();
  SkinRegion blue = everywhere(model), red = blue;
  red.colour = {0.5f, 0, 0};
  model.settings.skin = {blue, red};
  EXPECT_EQ(middle_of(drawn(model)).z, 0);
  model.settings.skin = {red, blue};
  EXPECT_EQ(middle_of(drawn(model)).x, 0);
}

TEST_F(BareSkinFrames, AtHalfItsSoftnessHalfOfItsLightIsSeen) {
  FurredModel model = ball(0);
  model.settings.look.skin = glm::vec3(0);
  model.settings.skin = {everywhere(model)};
  const auto blue = [&] { return std::pow((middle_of(drawn(model)).z / 255.0 + 0.055) / 1.055, 2.4); };
  const double whole = blue();
  EXPECT_GT(whole, 0.02);
  // The skin lies at 1.5 radii of the region: halfway across its soft edge, which is one radius wide.
  model.settings.skin[0].radii = glm::dvec3(0.5 / std::sqrt(3.0) / 1.5);
  model.settings.skin[0].softness = 2;
  EXPECT_NEAR(blue(), 0.5 * whole, 0.04 * whole);
}

TEST_F(BareSkinFrames, FacesADirection) {
  FurredModel model = ball();
  SkinRegion front = everywhere(model);
  front.facing = SkinFacing{.direction = {0, 0, 1}, .angle_degrees = 60, .fade_degrees = 10};
  model.settings.skin = {front};
  const auto from = [&](AutoView view) { return draw(*renderer, model, small_frame(view)); };
  EXPECT_EQ(middle_of(from(AutoView::front)).x, 0);
  EXPECT_GT(middle_of(from(AutoView::back)).x, 20);
  model = ball(0);  // without fur: the region's colour has to face the same direction
  model.settings.skin = {front};
  EXPECT_EQ(middle_of(from(AutoView::front)).x, 0);
  EXPECT_GT(middle_of(from(AutoView::back)).x, 20);
}

TEST_F(BareSkinFrames, HasTheSameShapeInShadersAndOnVertices) {
  // Upright fur around a cap of blue skin: seen from the front, the pixels without red are the cap.
  FurredModel model = coarse(furred({Builtin::sphere, 20000}, {.length = 0.004, .inclination = 0}));
  const Mesh& mesh = model.model.surface.mesh();
  const double ball_radius = 0.5 / std::sqrt(3.0), cap = 0.12;
  SkinRegion region = everywhere(model);
  region.centre = mesh.to_model({0, 0, ball_radius}), region.radii = glm::dvec3(cap), region.softness = 0.02;
  model.settings.skin = {region};
  const Image image = draw(*renderer, model, small_frame(AutoView::front, 256));
  double blue = 0, all = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] < 128) continue;
    all += 1, blue += image.rgba[i] == 0 ? 1 : 0;
  }
  // A ball of radius c around a point on a ball of radius R cuts it in a circle of radius c sqrt(1 - c^2 / 4 R^2).
  const double circle = cap * std::sqrt(1 - cap * cap / (4 * ball_radius * ball_radius));
  const double eye = glm::length(make_frame(model.view(), small_frame()).camera.position), furry = ball_radius + 0.004;
  const double seen = circle / (eye - ball_radius + cap * cap / (2 * ball_radius));
  EXPECT_NEAR(std::sqrt(blue / all), seen / (furry / std::sqrt(eye * eye - furry * furry)), 0.025);
}

/// Width and height, in pixels, of the opaque area without red.
glm::ivec2 extent_of_blue(const Image& image) {
  glm::ivec2 low(image.width, image.height), high(0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
      if (image.rgba[i + 3] < 255 || image.rgba[i] > 0) continue;
      low = glm::min(low, {x, y}), high = glm::max(high, {x + 1, y + 1});
    }
  }
  return high - low;
}

TEST_F(BareSkinFrames, TurnsAroundItsAxis) {
  FurredModel model = coarse(furred({Builtin::sphere, 20000}, {.length = 0.004, .inclination = 0}));
  SkinRegion region = everywhere(model);
  region.radii = {0.16, 0.08, 1}, region.softness = 0.02;
  model.settings.skin = {region};
  const glm::ivec2 level = extent_of_blue(drawn(model));
  EXPECT_NEAR(level.x, 2 * level.y, 5);
  model.settings.skin[0].turn_degrees = 90;
  const glm::ivec2 upright = extent_of_blue(drawn(model));
  EXPECT_NEAR(upright.x, level.y, 3);
  EXPECT_NEAR(upright.y, level.x, 3);
}

TEST_F(BareSkinFrames, ExtremesGiveFinitePictures) {
  FurredModel model = ball();
  model.settings.lights = {{.kind = LightKind::point, .position = {0, 0, 0}, .intensity = 1e8}};
  FrameRequest request = small_frame(AutoView::front, 24);
  request.background = Background::colour;
  for (const double radius : {1e-6, 0.3, 1e6}) {
    for (const double finish : {0.0, 1.0}) {
      SkinRegion region = everywhere(model);
      region.radii = {radius, 1e-6, 1e6};
      region.softness = 10 * finish;
      region.shine = region.wetness = region.scatter = finish, region.roughness = 0.02;
      region.bumps = {.height = 0.1, .size = finish > 0 ? 1e-4 : 1};
      region.facing = SkinFacing{.angle_degrees = 180 * finish, .fade_degrees = 0};
      model.settings.skin.assign(limits::skin_regions, region);
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
    }
  }
}

}  // namespace
}  // namespace pelage::testing::bare_skin_test
