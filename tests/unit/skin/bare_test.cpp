#include "renderer/skin/bare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pelage {
namespace {

constexpr glm::dvec3 up{0, 1, 0};

FurSkinRegion ball(double radius, double softness) {
  FurSkinRegion region;
  region.centre = {0.1, 0.2, 0.3};
  region.to_unit = glm::dmat3(1 / radius);
  region.softness = softness;
  return region;
}

double at(const FurSkinRegion& region, double off) { return bare_share(region, region.centre + off * up, up); }

TEST(BareSkin, IsWholeInsideAndEndsAtItsSoftness) {
  const FurSkinRegion region = ball(0.1, 0.5);
  EXPECT_EQ(at(region, 0), 1);
  EXPECT_EQ(at(region, 0.0999), 1);
  EXPECT_NEAR(at(region, 0.125), 0.5, 1e-12);  // halfway in a smoothstep from 0.1 to 0.15
  EXPECT_NEAR(at(region, 0.1125), 1 - 0.15625, 1e-12);
  EXPECT_NEAR(at(region, 0.1375), 0.15625, 1e-12);
  EXPECT_EQ(at(region, 0.1501), 0);
}

TEST(BareSkin, FallsAllTheWay) {
  const FurSkinRegion region = ball(0.1, 2);
  double before = 1;
  for (int i = 0; i <= 400; ++i) {
    const double share = at(region, 0.001 * i);
    EXPECT_LE(share, before);
    EXPECT_GE(share, 0);
    before = share;
  }
  EXPECT_EQ(before, 0);
}

TEST(BareSkin, WithoutSoftnessIsAStep) {
  const FurSkinRegion region = ball(0.1, 0);
  EXPECT_EQ(at(region, 0.0999), 1);
  EXPECT_EQ(at(region, 0.1001), 0);
}

TEST(BareSkin, HasThreeRadii) {
  FurSkinRegion region = ball(1, 0);
  region.to_unit = {{10, 0, 0}, {0, 5, 0}, {0, 0, 2}};  // radii 0.1, 0.2, 0.5
  const auto share = [&](glm::dvec3 off) { return bare_share(region, region.centre + off, up); };
  EXPECT_EQ(share({0.09, 0, 0}), 1);
  EXPECT_EQ(share({0.11, 0, 0}), 0);
  EXPECT_EQ(share({0, 0.19, 0}), 1);
  EXPECT_EQ(share({0, 0.21, 0}), 0);
  EXPECT_EQ(share({0, 0, 0.49}), 1);
  EXPECT_EQ(share({0, 0, 0.51}), 0);
  EXPECT_EQ(share({0.08, 0.16, 0}), 0);
}

TEST(BareSkin, FacesADirection) {
  FurSkinRegion region = ball(0.1, 0.5);
  region.facing = up;
  region.cosine_full = std::cos(glm::radians(60.0)), region.cosine_none = std::cos(glm::radians(90.0));
  const auto share = [&](double degrees) {
    const double angle = glm::radians(degrees);
    return bare_share(region, region.centre, {std::sin(angle), std::cos(angle), 0});
  };
  EXPECT_EQ(share(0), 1);
  EXPECT_EQ(share(59), 1);
  EXPECT_NEAR(share(std::acos(0.25) * 180 / 3.14159265358979), 0.5, 1e-9);
  EXPECT_EQ(share(91), 0);
  EXPECT_EQ(share(180), 0);
}

TEST(BareSkin, RegionsTakeFurFromEachOtherInAnyOrder) {
  FurSkinRegion near = ball(0.1, 0.5), far = ball(0.12, 1);
  const glm::dvec3 position = near.centre + 0.13 * up;
  const double kept_near = 1 - bare_share(near, position, up), kept_far = 1 - bare_share(far, position, up);
  const std::vector<FurSkinRegion> one{near, far}, other{far, near};
  EXPECT_NEAR(fur_share(one, position, up), kept_near * kept_far, 1e-15);
  EXPECT_EQ(fur_share(one, position, up), fur_share(other, position, up));
  EXPECT_EQ(fur_share({}, position, up), 1);
  EXPECT_EQ(fur_share(one, near.centre, up), 0);
}

TEST(BareSkin, StaysWithinItsBoundsAtTheExtremes) {
  for (const double radius : {1e-6, 1.0, 1e6}) {
    for (const double softness : {0.0, 1e-300, 10.0}) {
      FurSkinRegion region = ball(radius, softness);
      for (const double off : {0.0, 1e-12, 1e-6, 1.0, 1e6}) {
        for (const glm::dvec3 normal : {up, -up, glm::dvec3(0)}) {
          const double share = bare_share(region, region.centre + off * up, normal);
          EXPECT_TRUE(share >= 0 && share <= 1) << radius << " " << softness << " " << off;
        }
      }
    }
  }
}

}  // namespace
}  // namespace pelage
