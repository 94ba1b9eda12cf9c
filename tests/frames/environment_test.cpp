// An environment picture lights fur: each side takes the colour that comes from its direction.
#include "renderer/light/environment.h"

#include <cmath>

#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::environment_test {
namespace {

class EnvironmentLight : public WithRenderer {
 protected:
  Image draw_in(const Environment& environment, ShadingModel shading = ShadingModel::kajiya) {
    FurredModel model = coarse(furred({Builtin::sphere, 1000}));
    model.settings.lights.clear();
    model.settings.coats[0].coat.ramp = {{0, glm::vec3(0.5f)}};
    model.settings.look.shading = shading;
    model.settings.environment = environment;
    return draw(*renderer, model, small_frame(AutoView::front, 128));
  }
};

Environment with_light(const SphericalHarmonics& harmonics) {
  Environment environment;
  environment.harmonics = harmonics;
  return environment;
}

/// An environment picture whose left half is red and right half is blue.
Environment red_and_blue() {
  std::vector<float> rgba;
  for (int i = 0; i < 8 * 4; ++i) rgba.insert(rgba.end(), {i % 8 < 4 ? 1.0f : 0.0f, 0, i % 8 < 4 ? 0.0f : 1.0f, 1});
  return with_light(project_equirectangular(8, 4, rgba).value());
}

/// Mean colour of a column of the picture's middle rows.
glm::dvec3 colour_at(const Image& image, int column) {
  glm::dvec3 sum(0);
  for (int row = 54; row < 74; ++row) {
    const std::size_t at = 4 * static_cast<std::size_t>(row * image.width + column);
    sum += glm::dvec3(image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]) / 20.0;
  }
  return sum;
}

TEST_F(EnvironmentLight, ComesFromWhereThePictureHasIt) {
  const Image image = draw_in(red_and_blue());
  const glm::dvec3 left = colour_at(image, 36), right = colour_at(image, 92);
  EXPECT_GT(left.x, left.z + 20);
  EXPECT_GT(right.z, right.x + 20);
  EXPECT_LT(std::max(left.y, right.y), 2);
}

TEST_F(EnvironmentLight, TurnsWithItsAngle) {
  Environment environment = red_and_blue();
  environment.turn_degrees = 180;
  const Image image = draw_in(environment);
  const glm::dvec3 left = colour_at(image, 36), right = colour_at(image, 92);
  EXPECT_GT(left.z, left.x + 20);
  EXPECT_GT(right.x, right.z + 20);
}

TEST_F(EnvironmentLight, AWhitePictureIsConstantLight) {
  const std::vector<float> rgba(4 * 8 * 4, 1.0f);
  const Image picture = draw_in(with_light(project_equirectangular(8, 4, rgba).value())), constant = draw_in({});
  EXPECT_LE(largest_difference(picture, constant), 1);
  EXPECT_GT(mean_colour(picture).y, 20);
}

TEST_F(EnvironmentLight, ExtremesStayFinite) {
  SphericalHarmonics largest, min;
  largest.fill(glm::dvec3(1e6)), min.fill(glm::dvec3(-1e6));
  for (const ShadingModel shading : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::energy_conserving}) {
    Environment environment = with_light(largest);
    environment.intensity = 100;
    EXPECT_GT(mean_colour(draw_in(environment, shading)).y, 200);
    EXPECT_LT(mean_colour(draw_in(with_light(SphericalHarmonics{}), shading)).y, 1);
    environment = with_light(min);
    environment.intensity = 100;
    const Image dark = draw_in(environment, shading);
    EXPECT_GT(covered(dark), 0.2);
  }
}

}  // namespace
}  // namespace pelage::testing::environment_test
