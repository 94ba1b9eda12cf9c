#include "renderer/visibility/depth_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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
  const std::vector<DepthRange> parts = depth_parts(from_ten_away(), deep, 4);
  ASSERT_EQ(parts.size(), 4u);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto distance =
        static_cast<float>(i < 1000 ? 20 * random.uniform() - 2 : 8 + i % 5);  // and at the boundaries
    EXPECT_EQ(std::count_if(parts.begin(), parts.end(), [&](const DepthRange& part) { return part.holds(distance); }),
              1)
        << distance;
  }
}

/// The GL compares one over the distance, which it has at hand.
TEST(DepthParts, InverseDistancesBelongToOneToo) {
  const std::vector<DepthRange> parts = depth_parts(from_ten_away(), deep, 4);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const float inverse = 1 / static_cast<float>(20 * random.uniform() + 1e-3);
    const auto holds = [&](const DepthRange& part) {
      return inverse > part.inverse_begin() && inverse <= part.inverse_end();
    };
    EXPECT_EQ(std::count_if(parts.begin(), parts.end(), holds), 1) << inverse;
  }
}

TEST(DepthParts, TheyRunFromFarToNear) {
  const std::vector<DepthRange> parts = depth_parts(from_ten_away(), deep, 4);
  EXPECT_TRUE(parts[0].holds(100));
  EXPECT_TRUE(parts[0].holds(11.5f));
  EXPECT_TRUE(parts[1].holds(10.5f));
  EXPECT_TRUE(parts[3].holds(8.5f));
  EXPECT_TRUE(parts[3].holds(-100));
}

TEST(DepthParts, WhatHasNoDepthIsOnePart) {
  EXPECT_EQ(depth_parts(from_ten_away(), std::vector<glm::vec3>(3, glm::vec3(0)), 4).size(), 1u);
  EXPECT_EQ(depth_parts(from_ten_away(), {}, 4).size(), 1u);
}

TEST(DepthParts, FurIsInEachThatItMayReach) {
  const glm::uvec3 triangle{0, 1, 2};
  const auto parts_with = [&](float length, float stretch) {
    const std::vector<float> lengths(3, length);
    const std::vector<glm::vec3> positions(3, {0, 0, 0.5f});  // in the third part, half a size from both others
    const std::vector<glm::vec2> distances = distances_of_fur(from_ten_away(), positions, lengths, stretch);
    std::vector<bool> in;
    for (const DepthRange& part : depth_parts(from_ten_away(), deep, 4))
      in.push_back(!triangles_in(part, distances, {&triangle, 1}).empty());
    return in;
  };
  EXPECT_EQ(parts_with(0.4f, 1), (std::vector<bool>{false, false, true, false}));
  EXPECT_EQ(parts_with(0.4f, 2), (std::vector<bool>{false, true, true, true}));
  EXPECT_EQ(parts_with(0.6f, 1), (std::vector<bool>{false, true, true, true}));
  EXPECT_EQ(parts_with(2, 1), (std::vector<bool>{true, true, true, true}));
}

}  // namespace
}  // namespace pelage
