#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "renderer/curves/curve_strips.h"

namespace pelage {
namespace {

constexpr std::array<glm::dvec3, 5> bent{{{0, 0, 0}, {1, 0.5, 0}, {1.5, 2, -1}, {4, 2, 0}, {4, 5, 3}}};

TEST(Spline, PassesThroughItsPoints) {
  for (std::size_t i = 0; i < bent.size(); ++i)
    EXPECT_LT(glm::distance(spline_point(bent, static_cast<double>(i) / 4), bent[i]), 1e-14) << i;
}

TEST(Spline, TwoPointsGiveAStraightLine) {
  const std::array<glm::dvec3, 2> line{{{1, 2, 3}, {3, -2, 7}}};
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
    EXPECT_LT(glm::distance(spline_point(line, t), glm::mix(line[0], line[1], t)), 1e-14) << t;
}

TEST(Spline, HasNoKinks) {  // the slopes on both sides of an inner point agree
  const double h = 1e-6;
  for (const double at : {0.25, 0.5, 0.75}) {
    const glm::dvec3 before = (spline_point(bent, at) - spline_point(bent, at - h)) / h;
    const glm::dvec3 after = (spline_point(bent, at + h) - spline_point(bent, at)) / h;
    EXPECT_LT(glm::distance(before, after), 1e-3) << at;
    EXPECT_GT(glm::length(before), 1) << at;
  }
}

TEST(Spline, StaysAtItsEndsOutsideOfTheRange) {
  EXPECT_EQ(spline_point(bent, -1), bent.front());
  EXPECT_EQ(spline_point(bent, 2), bent.back());
}

TEST(Spline, PointsThatCoincideAreFinite) {
  const std::vector<glm::dvec3> one_position(4, glm::dvec3(1e6, -1e6, 0));
  for (const double t : {0.0, 0.1, 0.5, 1.0}) EXPECT_EQ(spline_point(one_position, t), one_position[0]);
}

}  // namespace
}  // namespace pelage
