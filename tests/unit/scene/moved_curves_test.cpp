// Whiskers in the wind.
#include "server/frames/moved_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

/// A straight whisker and one bent to the side.
FurCurves whiskers() {
  FurCurves curves;
  curves.guides.push_back({.points = {{0, 0, 0}, {0, 0.05, 0}, {0, 0.1, 0}}});
  curves.guides.push_back({.points = {{0.2, 0, 0}, {0.24, 0.05, 0.02}, {0.3, 0.07, 0.05}, {0.38, 0.06, 0.1}}});
  return curves;
}

const Wind breeze{.speed = 1, .direction = {1, 0, 0}, .gusts = 0.3, .turbulence = 0.2};

TEST(MovedCurves, StandStillWithoutWind) {
  FurCurves curves = whiskers();
  sway_curves(curves, Wind{.speed = 0}, 1.5);
  EXPECT_EQ(curves, whiskers());
}

TEST(MovedCurves, KeepTheirRootsAndTheLengthOfEachSegment) {
  for (const double speed : {0.5, 20.0, 1e6}) {
    for (const double moment : {-1e6, 0.0, 0.37, 1e6}) {
      Wind wind = breeze;
      wind.speed = speed;
      FurCurves curves = whiskers();
      sway_curves(curves, wind, moment);
      const FurCurves rest = whiskers();
      for (std::size_t c = 0; c < rest.guides.size(); ++c) {
        const auto &before = rest.guides[c].points, &after = curves.guides[c].points;
        ASSERT_EQ(after.front(), before.front());
        for (std::size_t i = 1; i < before.size(); ++i) {
          const double length = glm::distance(before[i], before[i - 1]), now = glm::distance(after[i], after[i - 1]);
          ASSERT_NEAR(now, length, 1e-9) << speed << " " << moment;
        }
        ASSERT_NE(after.back(), before.back());
      }
    }
  }
}

TEST(MovedCurves, BendWithTheWindAndMoreTowardsTheTip) {
  glm::dvec3 tip(0), middle(0);
  constexpr int moments = 200;
  for (int k = 0; k < moments; ++k) {
    FurCurves curves = whiskers();
    sway_curves(curves, breeze, 0.1 * k);
    tip += curves.guides[0].points[2] / double{moments}, middle += curves.guides[0].points[1] / double{moments};
  }
  EXPECT_GT(tip.x, 0.005);
  EXPECT_LT(std::abs(tip.z), 0.3 * tip.x);
  EXPECT_GT(tip.x, 2 * middle.x);
  EXPECT_LT(tip.y, 0.1);
}

TEST(MovedCurves, MoveSmoothlyAndTheSameAgain) {
  const auto tip_at = [](double moment) {
    FurCurves curves = whiskers();
    sway_curves(curves, breeze, moment);
    return curves.guides[1].points.back();
  };
  EXPECT_EQ(tip_at(2.25), tip_at(2.25));
  double farthest = 0;
  for (double t = 0; t < 4; t += 1.0 / 240)
    farthest = std::max(farthest, glm::distance(tip_at(t), tip_at(t + 1.0 / 240)));
  EXPECT_GT(farthest, 0);
  EXPECT_LT(farthest, 0.01);
}

TEST(MovedCurves, LagBehindABodyThatSetsOff) {
  const auto setting_off = [](std::uint32_t curve, double) { return glm::dvec3(curve == 0 ? 4 : 0, 0, 0); };
  const BodyMotion body{setting_off, 1.0 / 24};
  FurCurves curves = whiskers();
  sway_curves(curves, Wind{.speed = 0}, 1.5, &body);
  const FurCurves rest = whiskers();
  EXPECT_LT(curves.guides[0].points[2].x, -1e-3);
  EXPECT_NEAR(glm::distance(curves.guides[0].points[2], curves.guides[0].points[1]), 0.05, 1e-9);
  EXPECT_EQ(curves.guides[1], rest.guides[1]) << "its skin rests";
}

TEST(MovedCurves, MoveAsTheVertexAtTheirRoot) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 0.1f}, {0.1f, 0, 0}, {5, 0, 0}, {5, 0, 0.1f}, {5.1f, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Surface surface(mesh);
  FurCurves curves;
  curves.guides.push_back({.points = {{5, 0, 0}, {5, 1, 0}}});
  curves.guides.push_back({.points = {{0, 0.01, 0}, {0, 1, 0}}});
  const BodySwing swing{[](std::uint32_t vertex, double time) { return glm::dvec3(vertex, time, 0); }, 0.5};
  const BodyMotion motion = motion_under(curves, surface, swing);
  EXPECT_EQ(motion.acceleration(0, 2), glm::dvec3(3, 2, 0));
  EXPECT_EQ(motion.acceleration(1, 7), glm::dvec3(0, 7, 0));
  EXPECT_EQ(motion.step, 0.5);
}

TEST(MovedCurves, WithoutLengthDoNoHarm) {
  FurCurves curves;
  curves.guides.push_back({.points = {{0, 0, 0}, {0, 0, 0}}});
  sway_curves(curves, breeze, 1);
  for (const glm::dvec3& point : curves.guides[0].points) EXPECT_EQ(point, glm::dvec3(0));
}

}  // namespace
}  // namespace pelage
