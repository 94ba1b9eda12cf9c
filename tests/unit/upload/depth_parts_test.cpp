#include "renderer/visibility/depth_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "protocol/base/lean_curve.h"
#include "protocol/base/random.h"

namespace pelage {
namespace {

/// Straight on from 10 away: what lies at z is 10 - z off.
glm::mat4 from_ten_away() {
  glm::mat4 to_clip(1);
  to_clip[2][3] = -1, to_clip[3][3] = 10;
  return to_clip;
}

const std::vector<glm::vec3> deep = {{0, 0, -2}, {0, 0, 2}, {1, 0, 0}};

TEST(DepthParts, EveryDistanceBelongsToOne) {
  const DepthParts parts(from_ten_away(), deep, 4);
  ASSERT_EQ(parts.count(), 4);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto distance =
        static_cast<float>(i < 1000 ? 20 * random.uniform() - 2 : 8 + i % 5);  // and at the boundaries
    int holding = 0;
    for (int part = 0; part < 4; ++part) holding += parts.range(part).holds(distance);
    EXPECT_EQ(holding, 1) << distance;
    EXPECT_TRUE(parts.range(parts.at(distance)).holds(distance)) << distance;
  }
}

/// The GL compares one over the distance, which it has at hand.
TEST(DepthParts, InverseDistancesBelongToOneToo) {
  const DepthParts parts(from_ten_away(), deep, 4);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const float inverse = 1 / static_cast<float>(20 * random.uniform() + 1e-3);
    int holding = 0;
    for (int part = 0; part < 4; ++part) {
      const DepthRange range = parts.range(part);
      holding += inverse > range.inverse_begin() && inverse <= range.inverse_end();
    }
    EXPECT_EQ(holding, 1) << inverse;
  }
}

TEST(DepthParts, TheyRunFromFarToNear) {
  const DepthParts parts(from_ten_away(), deep, 4);
  EXPECT_EQ(parts.at(100), 0);
  EXPECT_EQ(parts.at(11.5f), 0);
  EXPECT_EQ(parts.at(10.5f), 1);
  EXPECT_EQ(parts.at(8.5f), 3);
  EXPECT_EQ(parts.at(-100), 3);
}

TEST(DepthParts, WhatHasNoDepthIsOnePart) {
  EXPECT_EQ(DepthParts(from_ten_away(), std::vector<glm::vec3>(3, glm::vec3(0)), 4).count(), 1);
  EXPECT_EQ(DepthParts(from_ten_away(), {}, 4).count(), 1);
}

/// Random strands, seen from random sides, near and so far away that distances are rounded: no place of a triangle's
/// shell is outside of what is said of it.
TEST(DepthParts, StrandsStayWithinTheirDepths) {
  Random random(3);
  const auto number = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const auto direction = [&] { return glm::normalize(glm::vec3(number(-1, 1), number(-1, 1), number(-1, 1)) + 1e-3f); };
  for (int i = 0; i < 3000; ++i) {
    Coat coat;
    coat.lean_curve = i % 2 ? LeanCurve::root : LeanCurve::arc, coat.root_share = number(0, 1);
    coat.variation.length = i % 3 ? 0 : number(0, 1), coat.variation.lean = i % 5 ? 0 : number(0, 1);
    const glm::vec3 normal = direction(), along = direction();
    const glm::vec3 tangent = glm::normalize(glm::cross(normal, glm::vec3(0.3, 0.5, 0.7)));
    const double inclination = number(0, 1), turn = number(0, 6.3), length = number(0, 0.3);
    const std::vector<glm::vec3> positions(3, direction()), normals(3, normal), tangents(3, tangent);
    const std::vector<glm::vec3> grooms(3,
                                        glm::vec3(inclination * std::cos(turn), inclination * std::sin(turn), length));
    glm::mat4 to_clip(1);
    for (int k = 0; k < 3; ++k) to_clip[k][3] = along[k];
    to_clip[3][3] = static_cast<float>(i % 4 ? 1 : number(1, 1e5));
    StrandDepths depths({positions, normals, tangents, grooms}, coat, to_clip);
    const double height = number(0, 1);
    const glm::vec2 range = depths.of({0, 1, 2}, glm::vec3(static_cast<float>(height)));
    const double leaning = std::clamp(inclination + coat.variation.lean * number(-1, 1), 0.0, 1.0);
    const LeanPoint at = lean_point(coat.lean_curve, leaning, coat.root_share, height);
    const glm::vec3 lean =
        tangent * static_cast<float>(std::cos(turn)) + glm::cross(normal, tangent) * static_cast<float>(std::sin(turn));
    const auto drawn = static_cast<float>(length * (1 + coat.variation.length * number(-1, 1)));
    const glm::vec3 place =
        positions[0] + drawn * (static_cast<float>(at.across) * lean + static_cast<float>(at.up) * normal);
    const double distance = glm::dot(glm::dvec3(along), glm::dvec3(place)) + double{to_clip[3][3]};
    EXPECT_GE(distance, range.x) << i;
    EXPECT_LE(distance, range.y) << i;
    if (coat.variation.lean > 0) continue;
    EXPECT_LT(range.y - range.x, length * (0.1 + 4 * coat.variation.length) + 1e-4 * std::abs(distance) + 1e-4) << i;
  }
}

}  // namespace
}  // namespace pelage
