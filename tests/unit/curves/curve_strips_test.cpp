#include "renderer/curves/curve_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr std::size_t points_of_curve = curve_segments + 1;

/// Straight guides of length 1 along Z, in a row on the X axis.
FurCurves comb_of(int guides, int fill, double spread = 0) {
  FurCurves group;
  for (int g = 0; g < guides; ++g) {
    const double x = g;
    group.guides.push_back({.points = {{x, 0, 0}, {x, 0, 1}}, .normal = {0, 0, 1}});
  }
  group.width_root = 0.01, group.width_tip = 0.001;
  group.root_colour = {1, 0.5f, 0.25f}, group.tip_colour = {0, 0.5f, 1};
  group.fill = fill, group.spread = spread;
  return group;
}

CurveStrips strips_of(const FurCurves& group) { return make_strips({&group, 1}); }
glm::vec3 root_of(const CurveStrips& strips, std::size_t curve) { return strips.points[curve * points_of_curve]; }
glm::vec3 tip_of(const CurveStrips& strips, std::size_t curve) {
  return strips.points[curve * points_of_curve + curve_segments];
}

void expect_finite(const CurveStrips& strips) {
  for (const glm::vec3& point : strips.points) {
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(point[k]));
  }
  for (const CurveStyle& style : strips.styles) EXPECT_NEAR(glm::length(glm::vec3(style.normal)), 1, 1e-6);
}

TEST(CurveStrips, GuidesAloneAreDrawnAsTheyAreGiven) {
  FurCurves group = comb_of(3, 0, 1);  // spread moves only the strands between guides
  group.guides[1].points = {{1, 0, 0}, {1, 1, 0}, {2, 1, 0}};
  const CurveStrips strips = strips_of(group);
  ASSERT_EQ(strips.styles.size(), 3u);
  ASSERT_EQ(strips.points.size(), 3 * points_of_curve);
  EXPECT_EQ(strips.points[points_of_curve + curve_segments / 2], glm::vec3(1, 1, 0));
  EXPECT_EQ(tip_of(strips, 1), glm::vec3(2, 1, 0));
  EXPECT_EQ(strips.styles[0].root, glm::vec4(1, 0.5f, 0.25f, 0.01f));
  EXPECT_EQ(strips.styles[0].tip, glm::vec4(0, 0.5f, 1, 0.001f));
}

TEST(CurveStrips, FillLiesEvenlyBetweenNeighbours) {
  const CurveStrips strips = strips_of(comb_of(3, 4));
  ASSERT_EQ(strips.styles.size(), 11u);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_NEAR(root_of(strips, i).x, static_cast<double>(i) / 5, 1e-6) << i;
    EXPECT_NEAR(tip_of(strips, i).z, 1, 1e-6) << i;
  }
}

TEST(CurveStrips, SpreadIsWithinWhatTheContractSays) {
  const CurveStrips strips = strips_of(comb_of(2, 400, 1));
  double shortest = 9, longest = 0, widest = 0;
  for (std::size_t i = 1; i + 1 < strips.styles.size(); ++i) {
    const glm::dvec3 root = root_of(strips, i), along = glm::dvec3(tip_of(strips, i)) - root;
    EXPECT_NEAR(root.x * 401, static_cast<double>(i), 0.5 + 1e-6);
    EXPECT_EQ(root.z, 0);
    const double length = glm::length(along);
    shortest = std::min(shortest, length), longest = std::max(longest, length);
    widest = std::max(widest, glm::degrees(std::acos(along.z / length)));
  }
  EXPECT_NEAR(shortest, 0.55, 0.05);
  EXPECT_NEAR(longest, 1.45, 0.05);
  EXPECT_NEAR(widest, 28.5, 1.5);
}

TEST(CurveStrips, TheSameSeedGivesTheSameBits) {
  FurCurves group = comb_of(4, 7, 0.5);
  const CurveStrips first = strips_of(group), again = strips_of(group);
  EXPECT_EQ(first.points, again.points);
  EXPECT_EQ(first.styles, again.styles);
  group.seed = 2;
  EXPECT_NE(first.points, strips_of(group).points);
}

TEST(CurveStrips, ExtremesAreFinite) {
  FurCurves group = comb_of(2, 3, 1);
  group.guides[0].points = {{1, 1, 1}, {1, 1, 1}};   // no length
  group.guides[0].normal = -group.guides[1].normal;  // their mean has no direction in the middle
  expect_finite(strips_of(group));
  group.guides[0].points = {{-1e6, 1e6, 1e6}, {1e6, -1e6, -1e6}, {-1e6, 1e6, 1e6}};
  expect_finite(strips_of(group));
  group.width_root = group.width_tip = 0;
  expect_finite(strips_of(group));
}

}  // namespace
}  // namespace pelage
