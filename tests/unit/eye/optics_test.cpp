#include "renderer/eye/optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

constexpr double cornea = 1.376;

glm::dvec3 arriving(double degrees) {
  const double angle = glm::radians(degrees);
  return {std::sin(angle), 0, -std::cos(angle)};
}

double refracted_degrees(double degrees, double index) {
  const auto inside = refract_into(arriving(degrees), {0, 0, 1}, index);
  return glm::degrees(std::atan2(inside->x, -inside->z));
}

struct AirToCornea {
  double degrees, inside, reflected;
};

TEST(Optics, TheCorneaRefractsAndReflectsAsPublished) {  // science.md 5
  for (const AirToCornea& v :
       {AirToCornea{30, 21.3074, .02624}, {60, 39.0043, .06765}, {75, 44.5862, .22499}, {89, 46.6049, .89914}}) {
    EXPECT_NEAR(refracted_degrees(v.degrees, cornea), v.inside, 5e-5);
    EXPECT_NEAR(fresnel(std::cos(glm::radians(v.degrees)), cornea), v.reflected, 5e-6);
  }
}

TEST(Optics, TheCorneaShiftsTheIrisAsPublished) {
  const auto inside = *refract_into(arriving(60), {0, 0, 1}, cornea);
  EXPECT_NEAR(3.6 * inside.x / -inside.z, 2.916, 5e-4);
  const auto straight = *refract_into(arriving(60), {0, 0, 1}, 1);
  EXPECT_NEAR(3.6 * straight.x / -straight.z, 6.235, 5e-4);
}

TEST(Optics, TheWrongRatioLosesTheRayPastTheCriticalAngle) {
  EXPECT_TRUE(refract_into(arriving(46.60), {0, 0, 1}, 1 / cornea));
  EXPECT_FALSE(refract_into(arriving(46.62), {0, 0, 1}, 1 / cornea));
  const glm::dvec3 lost = glm::refract(arriving(60), glm::dvec3(0, 0, 1), cornea);
  EXPECT_EQ(glm::length(lost), 0);  // the pitfall: no NaN gives it away
}

TEST(Optics, DirectionsStayUnitAndFiniteAtTheExtremes) {
  for (const double index : {1.0, 1 + 1e-6, cornea, 3.0}) {
    for (const double degrees : {0.0, 45.0, 89.9, 90.0}) {
      const auto inside = refract_into(arriving(degrees), {0, 0, 1}, index);
      ASSERT_TRUE(inside);
      EXPECT_NEAR(glm::length(*inside), 1, 1e-12);
      const double reflected = fresnel(std::cos(glm::radians(degrees)), index);
      EXPECT_TRUE(reflected >= 0 && reflected <= 1) << index << " " << degrees;
    }
  }
  EXPECT_EQ(fresnel(0.5, 1), 0);
  EXPECT_EQ(fresnel(0, 1), 0);
  EXPECT_NEAR(fresnel(1, 3), 0.25, 1e-12);
}

TEST(Pupil, ClosesAsLightGrows) {
  double before = 1;
  for (double luminance = 1e-6; luminance < 1e6; luminance *= 10) {
    const double size = pupil_size(luminance);
    EXPECT_LT(size, before);
    before = size;
  }
  EXPECT_NEAR(pupil_size(1), 4.9 / 11.8, 1e-12);
  EXPECT_NEAR(pupil_size(0), 7.9 / 11.8, 1e-3);
  EXPECT_NEAR(pupil_size(1e30), 1.9 / 11.8, 1e-3);
}

}  // namespace
}  // namespace pelage
