// What a light sees of a mesh, and what stands on the ground hides of the sky.
#include "renderer/marched/depth_map.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "renderer/marched/ground_contact.h"
#include "renderer/marched/march_scene.h"
#include "renderer/marched/visible_triangles.h"

namespace pelage {
namespace {

constexpr int side = 64;

struct Square {
  std::vector<glm::vec3> places;
  std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};

  /// Level, at a height, `half` to each side of the middle.
  Square(float half, float height)
      : places{{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}} {}
};

LightView from_above() { return *view_of_light({.direction = {0, -1, 0}}, 0.75f, side); }

TEST(DepthMap, HoldsTheNearestLinearly) {
  Square far(0.5f, -0.2f);
  const Square near(0.25f, 0.3f);
  far.places.insert(far.places.end(), near.places.begin(), near.places.end());
  far.triangles.push_back({4, 5, 6}), far.triangles.push_back({4, 6, 7});
  const DepthMap map = draw_depth_map(far.places, far.triangles, from_above(), side, 2);
  EXPECT_NEAR(map.at(side / 2, side / 2), 0.75f - 0.3f, 1e-5);  // the ball's edge is depth 0
  EXPECT_NEAR(map.at(side / 2, 14), 0.75f + 0.2f, 1e-5);
  EXPECT_EQ(map.at(1, 1), DepthMap::nowhere);
}

TEST(DepthMap, LeavesNoTexelBetweenTwoTrianglesFree) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-0.4f, 0.4f);
  for (int i = 0; i < 50; ++i) {
    const std::vector<glm::vec3> places{{-0.5f, any(random), -0.5f},
                                        {0.5f, any(random), -0.5f},
                                        {0.5f, any(random), 0.5f},
                                        {-0.5f, any(random), 0.5f},
                                        {any(random), 0, any(random)}};
    const std::vector<glm::uvec3> fan{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const DepthMap map = draw_depth_map(places, fan, from_above(), side, 2);
    for (int y = 13; y < side - 13; ++y) {
      for (int x = 13; x < side - 13; ++x) ASSERT_LT(map.at(x, y), 2) << x << ", " << y;
    }
  }
}

TEST(DepthMap, DrawsWhatLiesBeforeALightOfATriangleThatReachesBehindIt) {
  const LightView light = *view_of_light({.kind = LightKind::point, .position = {0, 1, 0}}, 0.75f, side);
  const std::vector<glm::vec3> places{{-0.1f, 0, -0.1f}, {0.1f, 3, 0}, {0.1f, 0, 0.1f}};
  const std::vector<glm::uvec3> triangle{{0, 1, 2}};
  int seen = 0;
  for (const float depth : draw_depth_map(places, triangle, light, side, 1).depths) {
    if (depth == DepthMap::nowhere) continue;
    ++seen;
    ASSERT_TRUE(depth >= near_distance && depth <= 1.01f) << depth;
  }
  EXPECT_GT(seen, 20);
}

TEST(VisibleTriangles, KnowTheNearestTriangleAndThePlaceOnIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-0.4f, 0.4f);
  const LightView light = from_above();
  const PlainView view{light.world_to_clip, light.axis, side, side};
  for (int i = 0; i < 20; ++i) {
    std::vector<glm::vec3> places(9);
    for (glm::vec3& place : places) place = {any(random), any(random), any(random)};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    const std::vector<VisibleTriangle> seen = visible_triangles(places, triangles, view, 2);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!seen[k].there()) continue;
      const glm::uvec3& t = triangles[seen[k].triangle];
      const glm::vec3 place = at_visible(seen[k], places[t.x], places[t.y], places[t.z]);
      const glm::vec4 clip = light.world_to_clip * glm::vec4(place, 1);
      ASSERT_NEAR((clip.x * 0.5f + 0.5f) * side, static_cast<float>(k % side) + 0.5f, 0.01);
      ASSERT_NEAR((0.5f - clip.y * 0.5f) * side, static_cast<float>(k / side) + 0.5f, 0.01);
      ASSERT_NEAR(seen[k].depth, glm::dot(glm::vec3(light.axis), place) + light.axis.w, 1e-5);
    }
    EXPECT_EQ(std::memcmp(seen.data(), visible_triangles(places, triangles, view, 1).data(),
                          seen.size() * sizeof(VisibleTriangle)),
              0);
  }
}

float hidden_at(const GroundContact& contact, float x, float z) {
  const auto index = [](float place) {
    return static_cast<std::size_t>((place / GroundContact::extent + 1) * 0.5f * GroundContact::side);
  };
  return contact.hidden[index(z) * GroundContact::side + index(x)];
}

TEST(GroundContact, IsDarkUnderAPlateAndFadesBesideIt) {
  const Square plate(0.2f, -0.3f);
  const GroundContact on = make_ground_contact(plate.places, plate.triangles, -0.3f, 1);
  const GroundContact above = make_ground_contact(plate.places, plate.triangles, -0.5f, 2);
  EXPECT_GT(hidden_at(on, 0, 0), 0.9f);
  EXPECT_LT(hidden_at(above, 0, 0), 0.5f * hidden_at(on, 0, 0));
  float last = 1;
  for (const float x : {0.0f, 0.18f, 0.25f, 0.3f, 0.37f}) {
    EXPECT_LE(hidden_at(on, x, 0), last) << x;
    last = hidden_at(on, x, 0);
  }
  EXPECT_LT(hidden_at(on, 0.6f, 0.6f), 1e-6f);
  for (const float hidden : on.hidden) ASSERT_TRUE(hidden >= 0 && hidden <= 1);
  EXPECT_EQ(on.hidden, make_ground_contact(plate.places, plate.triangles, -0.3f, 2).hidden);
}

}  // namespace
}  // namespace pelage
