// The values of science.md 5 and the eye's extremes of science.md 7.
#include "renderer/shading/eye_optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "renderer/shading/fresnel.h"

namespace pelage {
namespace {

using std::numbers::pi;

double radians(double degrees) { return degrees * pi / 180; }

const glm::dvec3 up{0, 1, 0};

glm::dvec3 falling(double degrees) { return {std::sin(radians(degrees)), -std::cos(radians(degrees)), 0}; }

TEST(EyeOptics, RefractionAndFresnelIntoTheCornea) {
  const struct {
    double incidence, refracted, reflected;
  } rows[] = {{30, 21.3074, .02624}, {60, 39.0043, .06765}, {75, 44.5862, .22499}, {89, 46.6049, .89914}};
  for (const auto& row : rows) {
    const std::optional<glm::dvec3> inside = refract_ray(falling(row.incidence), up, 1 / cornea_index);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(std::atan2(inside->x, -inside->y) * 180 / pi, row.refracted, 5e-5);
    EXPECT_NEAR(fresnel_dielectric(std::cos(radians(row.incidence)), cornea_index), row.reflected, 5e-6);
  }
}

TEST(EyeOptics, TotalReflectionIsSaidAndNotAZeroVector) {
  EXPECT_TRUE(refract_ray(falling(46.60), up, cornea_index));
  EXPECT_FALSE(refract_ray(falling(46.62), up, cornea_index));
}

TEST(EyeOptics, IrisShift) {
  EXPECT_NEAR(iris_shift(lens_depth_mm, radians(60), cornea_index), 2.916, 5e-4);
  EXPECT_NEAR(iris_shift(lens_depth_mm, radians(60), 1), 6.235, 5e-4);
  EXPECT_EQ(iris_shift(0, radians(89.9), 1), 0);
}

TEST(EyeOptics, Extremes) {
  for (const double eta : {1.0, 1 + 1e-6, 1.376, 3.0}) {
    for (const double angle : {0.0, 60.0, 89.9}) {
      const std::optional<glm::dvec3> inside = refract_ray(falling(angle), up, 1 / eta);
      ASSERT_TRUE(inside);
      EXPECT_NEAR(glm::length(*inside), 1, 1e-12);
      const double reflected = fresnel_dielectric(std::cos(radians(angle)), eta);
      EXPECT_GE(reflected, 0);
      EXPECT_LE(reflected, 1);
      const double shift = iris_shift(3.6, radians(angle), eta);
      EXPECT_TRUE(std::isfinite(shift) && shift >= 0);
    }
  }
  EXPECT_EQ(fresnel_dielectric(1, 1), 0);
  EXPECT_EQ(fresnel_dielectric(0, 1.376), 1);
}

TEST(EyeOptics, PupilClosesAsLightGrows) {
  EXPECT_EQ(pupil_diameter_mm(0, 400), 7.75);
  EXPECT_NEAR(pupil_diameter_mm(846, 1), 7.75 - 5.75 / 3, 1e-12);
  EXPECT_NEAR(pupil_diameter_mm(1e30, 400), 2, 1e-6);
  EXPECT_EQ(pupil_diameter_mm(std::numeric_limits<double>::infinity(), 400), 2);
  double last = 8;
  for (double luminance = 1e-4; luminance < 1e6; luminance *= 10) {
    const double now = pupil_diameter_mm(luminance, 400);
    EXPECT_LT(now, last);
    last = now;
  }
}

TEST(EyeOptics, CorneaGathersWhatItsShadowCovers) {
  EXPECT_NEAR(cornea_cross_section(0, pi / 2), pi, 1e-6);
  EXPECT_NEAR(cornea_cross_section(pi / 2, pi / 2), pi / 2, 2e-4);
  EXPECT_NEAR(cornea_cross_section(0, radians(48)), pi * std::pow(std::sin(radians(48)), 2), 1e-6);
  EXPECT_EQ(cornea_cross_section(pi, radians(48)), 0);
  EXPECT_EQ(cornea_transmittance(pi, radians(48), cornea_index), 0);
}

TEST(EyeOptics, CorneaLetsLessThroughFromTheSide) {
  EXPECT_NEAR(cornea_transmittance(0, 1e-3, cornea_index), 1 - fresnel_dielectric(1, cornea_index), 1e-6);
  EXPECT_NEAR(cornea_transmittance(0.7, radians(48), 1), 1, 1e-12);
  const double front = cornea_transmittance(0, radians(48), cornea_index);
  const double side = cornea_transmittance(radians(80), radians(48), cornea_index);
  EXPECT_GT(front, 0.96);
  EXPECT_LT(side, front);
  EXPECT_GT(side, 0.5);
}

TEST(EyeOptics, CausticCarriesTheLightOfTheCornea) {
  const double flux = 2.5 * cornea_cross_section(0.5, 0.8) * cornea_transmittance(0.5, 0.8, cornea_index);
  const std::vector<double> weights{0, 1, 7, 2}, areas{0.1, 0.2, 0.05, 0.3};
  const double scale = caustic_scale(flux, weights, areas);
  double gathered = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) gathered += scale * weights[i] * areas[i];
  EXPECT_NEAR(gathered, flux, 1e-12);
  EXPECT_EQ(caustic_scale(flux, std::vector<double>{0, 0}, std::vector<double>{1, 1}), 0);
}

}  // namespace
}  // namespace pelage
