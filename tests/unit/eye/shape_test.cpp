#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/eye/iris_map.h"
#include "renderer/eye/optics.h"

namespace pelage {
namespace {

FurEye eye_with(double refraction, double bulge = 0.5, double size = 0.6, double depth = 0.15) {
  FurEye eye;
  eye.refraction = refraction, eye.bulge = bulge;
  eye.iris.size = size, eye.iris.depth = depth;
  return eye;
}

TEST(EyeShape, CorneaAndBallMeetAtTheLimbus) {
  for (const double bulge : {0.0, 0.5, 1.0}) {
    for (const double size : {0.1, 0.6, 0.95}) {
      const EyeShape shape = shape_of(eye_with(1.376, bulge, size));
      EXPECT_NEAR(std::hypot(size, shape.limbus), 1, 1e-12);
      EXPECT_NEAR(std::hypot(size, shape.limbus - shape.cornea_centre), shape.cornea_radius, 1e-9);
      EXPECT_GE(shape.cornea_centre + shape.cornea_radius, 1 - 1e-12);
    }
  }
  EXPECT_NEAR(shape_of(eye_with(1.376, 0)).cornea_radius, 1, 1e-12);
}

TEST(EyeShape, NoFibreReachesThroughTheLimbus) {
  FurEye eye = eye_with(1.376);
  eye.iris.depth = 0.02, eye.iris.relief = 0.2;
  EXPECT_EQ(shape_of(eye).relief, 0.02);
}

TEST(PupilShape, SlitOpensToARoundPupil) {
  EXPECT_EQ(pupil_axes(PupilShape::round, 0.4).width, 0.4);
  EXPECT_EQ(pupil_axes(PupilShape::round, 0.4).height, 0.4);
  const PupilAxes shut = pupil_axes(PupilShape::slit, 0), bright = pupil_axes(PupilShape::slit, 0.2),
                  full = pupil_axes(PupilShape::slit, 1);
  EXPECT_EQ(shut.width, 0);
  EXPECT_EQ(shut.height, 0);
  EXPECT_GT(bright.height, 2 * bright.width);
  EXPECT_NEAR(full.width, 1, 1e-12);
  EXPECT_NEAR(full.height, 1, 1e-12);
}

TEST(PupilShape, SeesTheLightsInFrontOfIt) {
  FurFrame frame;
  frame.look.ambient = 0;
  FurEye eye;
  EXPECT_EQ(luminance_at(eye, frame), 0);
  frame.lights = {{.kind = LightKind::directional, .direction = {0, 0, -1}, .radiance = glm::vec3(1)}};
  EXPECT_NEAR(luminance_at(eye, frame), 1000, 1e-3);
  frame.lights[0].direction = {0, 0, 1};
  EXPECT_EQ(luminance_at(eye, frame), 0);
  frame.lights = {{.kind = LightKind::point, .position = {0, 0, 2}, .radiance = glm::vec3(1)}};
  EXPECT_NEAR(luminance_at(eye, frame), 250, 1e-3);
  for (const LightKind kind : {LightKind::spot, LightKind::area}) {  // scaled by the cosine, and 0 behind the light
    frame.lights[0] = {.kind = kind,
                       .direction = {0, 0.6f, -0.8f},
                       .position = {0, 0, 2},
                       .radiance = glm::vec3(1),
                       .cone = 0,
                       .soft_cone = 1};
    EXPECT_NEAR(luminance_at(eye, frame), 0.8 * 250, 1e-3);
    frame.lights[0].direction = {0, 0.6f, 0.8f};
    EXPECT_EQ(luminance_at(eye, frame), 0);
    frame.lights[0].position = eye.position;
    EXPECT_TRUE(std::isfinite(luminance_at(eye, frame)));
  }
  frame.lights[0].kind = LightKind::point;
  EXPECT_TRUE(std::isfinite(luminance_at(eye, frame)));
}

double gathered(const std::vector<float>& maps, int angle, const EyeShape& shape) {
  constexpr std::ptrdiff_t texels = caustic_texels * caustic_texels;
  double sum = 0;
  std::for_each(maps.begin() + angle * texels, maps.begin() + (angle + 1) * texels, [&](float value) { sum += value; });
  return sum * std::pow(2 * shape.iris_radius / caustic_texels, 2);
}

TEST(Caustics, GatherWhatCameThroughTheCornea) {
  // Along the axis no light is lost on the wall: the flux is that through the disc of the limbus less what is
  // reflected, here summed over rings.
  for (const double index : {1.0, 1.376, 3.0}) {
    const EyeShape shape = shape_of(eye_with(index));
    double through = 0;
    constexpr int rings = 20000;
    for (int k = 0; k < rings; ++k) {
      const double radius = shape.iris_radius * (k + 0.5) / rings,
                   cosine = std::sqrt(1 - std::pow(radius / shape.cornea_radius, 2));
      through += 2 * 3.14159265358979 * radius * shape.iris_radius / rings * (1 - fresnel(cosine, index));
    }
    EXPECT_NEAR(gathered(gather_caustics(shape), 0, shape), through, 0.004 * through) << index;
  }
}

TEST(Caustics, WithoutACorneaTheLightFallsStraight) {
  const EyeShape shape = shape_of(eye_with(1, 0.5, 0.6, 0));
  const std::vector<float> maps = gather_caustics(shape);
  constexpr int angle = 8, middle = caustic_texels / 2;
  const float* map = maps.data() + angle * caustic_texels * caustic_texels;
  double mean = 0;
  for (int y = middle - 4; y < middle + 4; ++y) {
    for (int x = middle - 4; x < middle + 4; ++x) mean += map[y * caustic_texels + x] / 64;
  }
  EXPECT_NEAR(mean, std::cos(caustic_reach * angle / (caustic_angles - 1)), 0.02);
}

TEST(Caustics, BrightestOppositeTheLight) {
  const EyeShape shape = shape_of(eye_with(1.376));
  const std::vector<float> maps = gather_caustics(shape);
  constexpr int angle = 9;  // 54 degrees; the light comes from +X
  double near = 0, away = 0;
  for (int y = 0; y < caustic_texels; ++y) {
    for (int x = 0; x < caustic_texels; ++x) {
      const float value = maps[static_cast<std::size_t>((angle * caustic_texels + y) * caustic_texels + x)];
      (x < caustic_texels / 2 ? away : near) += value;
    }
  }
  EXPECT_GT(away, 1.3 * near);
}

TEST(Caustics, FiniteForEveryShape) {
  for (const double index : {1.0, 3.0}) {
    for (const double size : {0.1, 0.95}) {
      for (const double depth : {0.0, 0.5}) {
        const std::vector<float> maps = gather_caustics(shape_of(eye_with(index, 1, size, depth)));
        EXPECT_TRUE(std::all_of(maps.begin(), maps.end(), [](float v) { return std::isfinite(v) && v >= 0; }));
      }
    }
  }
}

TEST(IrisMap, JoinsAroundTheAxisAndVaries) {
  const std::vector<std::uint8_t> map = make_iris_map();
  ASSERT_EQ(map.size(), std::size_t{4} * iris_map_width * iris_map_height);
  double seam = 0, inside = 0, mean = 0, square = 0;
  for (int row = 0; row < iris_map_height; ++row) {
    const auto red = [&](int column) {
      return map[static_cast<std::size_t>(4 * (row * iris_map_width + column))] / 255.0;
    };
    seam += std::abs(red(0) - red(iris_map_width - 1)) / iris_map_height;
    inside += std::abs(red(500) - red(501)) / iris_map_height;
    mean += red(300) / iris_map_height, square += red(300) * red(300) / iris_map_height;
  }
  EXPECT_LT(seam, 2.5 * inside + 0.01);
  EXPECT_GT(mean, 0.2);
  EXPECT_GT(square - mean * mean, 0.005);
  EXPECT_EQ(map, make_iris_map());
}

}  // namespace
}  // namespace pelage
