#include "renderer/upload/layer_sets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

const LayerView view{{0, 0, 10}, 0.0005f, 16, ShellPolicy::adaptive};

glm::vec3 tilted(float degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

TEST(LayerSets, SharesAddUpToOne) {
  for (int i = 0; i <= 200; ++i) {
    const float level = static_cast<float>(i) / 100;
    float sum = 0;
    for (int set = 0; set < layer_sets; ++set) sum += set_share(level, set);
    EXPECT_NEAR(sum, 1, 1e-6) << level;
  }
}

TEST(LayerSets, MoreLayersTowardsTheOutline) {
  float last = -1;
  for (float degrees = 0; degrees <= 90; degrees += 1) {
    const float level = layer_level(view, {{0, 0, 0}, tilted(degrees), 0.1f, 0});
    EXPECT_GE(level, last) << degrees;
    EXPECT_LT(level - last, degrees == 0 ? 2.0f : 0.15f) << "a jump at " << degrees;
    last = level;
  }
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(last, layer_sets - 1);
}

TEST(LayerSets, FurThatIsSmallOnThePictureNeedsFew) {
  const glm::vec3 edge = tilted(89);
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, edge, 0.1f, 0}), 2);           // 20 pixels
  EXPECT_NEAR(layer_level(view, {{0, 0, 0}, edge, 0.04f, 0}), 1, 0.01);  // 8 pixels
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, edge, 0.01f, 0}), 0);          // 2 pixels
}

TEST(LayerSets, BentSkinNeedsMore) {
  const auto level = [](float curvature) { return layer_level(view, {{0, 0, 0}, tilted(0), 0.1f, curvature}); };
  EXPECT_EQ(level(0), 0);
  EXPECT_GT(level(8), level(4));
  EXPECT_EQ(level(100), layer_sets - 1);
}

TEST(LayerSets, CurvatureOfASphereIsOneOverItsRadius) {
  std::vector<glm::vec3> normals;
  std::vector<glm::uvec3> triangles;
  for (int row = 1; row < 40; ++row) {
    for (int column = 0; column < 80; ++column) {
      const float polar = 3.14159265f * static_cast<float>(row) / 40, turn = 3.14159265f * static_cast<float>(column) / 40;
      normals.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
    }
  }
  std::vector<glm::vec3> positions;
  for (const glm::vec3& n : normals) positions.push_back(0.25f * n);
  for (std::uint32_t i = 0; i + 80 < normals.size(); ++i) triangles.emplace_back(i, i + 1, i + 80);
  for (const float curvature : curvatures(positions, normals, triangles)) EXPECT_NEAR(curvature, 4, 1e-3);
}

TEST(LayerSets, ExtremesAreLevels) {
  for (const float length : {0.0f, 1e-20f, 10.0f, 1e20f}) {
    for (const glm::vec3 place : {glm::vec3(0, 0, 10), glm::vec3(0, 0, 1e6f), glm::vec3(0)}) {
      const float level = layer_level(view, {place, {0, 0, 1}, length, 1e6f});
      EXPECT_TRUE(level >= 0 && level <= layer_sets - 1) << level;
    }
  }
}

TEST(LayerSets, ShellsAndSteps) {
  EXPECT_EQ(shells_of_set(16, 0), 4);
  EXPECT_EQ(shells_of_set(16, 1), 8);
  EXPECT_EQ(shells_of_set(16, 2), 16);
  EXPECT_EQ(shells_of_set(1, 0), 1);
  EXPECT_EQ(steps_of_set(4, 2), 4);
  EXPECT_EQ(steps_of_set(4, 0), 8);
  EXPECT_EQ(steps_of_set(16, 0), 16);
}

TEST(LayerSets, EveryShareIsDrawn) {
  const std::vector<glm::uvec3> triangles = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}};
  const std::vector<glm::vec3> centroids(3, glm::vec3(0)), normals = {{0, 0, 1}, {1, 0, -0.2f}, {0, 0, -1}};
  const std::vector<float> levels = {0, 0.5f, 2};
  const LayerLists lists = sort_triangles({triangles, centroids, normals, levels}, view.eye);
  for (const LayerTriangles& set : lists) {  // corners at three levels: all sets
    EXPECT_EQ(set.facing.size(), 1u);
    EXPECT_EQ(set.averted.size(), 1u);  // the third is turned too far away
  }
  const std::vector<float> low = {0, 0.1f, 0};
  const LayerLists few = sort_triangles({triangles, centroids, normals, low}, view.eye);
  EXPECT_EQ(few[0].facing.size(), 1u);
  EXPECT_EQ(few[1].facing.size(), 0u);
  EXPECT_EQ(shown_triangles({triangles, centroids, normals, levels}, view.eye).size(), 2u);
}

}  // namespace
}  // namespace pelage
