#include "renderer/upload/layer_sets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

const LayerView view{{0, 0, 10}, 0.0005f, 32, ShellPolicy::adaptive};

glm::vec3 tilted(float degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

TEST(LayerSets, MoreLayersTowardsTheOutline) {
  float last = 3;
  for (float degrees = 0; degrees <= 90; degrees += 1) {
    const float level = layer_level(view, {{0, 0, 0}, tilted(degrees), 0.2f, 0});
    EXPECT_LE(level, last) << degrees;
    EXPECT_LT(last - level, degrees == 0 ? 2.0f : 0.15f) << "a jump at " << degrees;
    last = level;
  }
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, tilted(0), 0.2f, 0}), 2);
  EXPECT_EQ(last, 0);
}

TEST(LayerSets, FurThatIsSmallOnThePictureNeedsFew) {
  const glm::vec3 edge = tilted(89);
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, edge, 0.1f, 0}), 0);           // 20 pixels
  EXPECT_NEAR(layer_level(view, {{0, 0, 0}, edge, 0.04f, 0}), 1, 0.01);  // 8 pixels
  EXPECT_EQ(layer_level(view, {{0, 0, 0}, edge, 0.01f, 0}), 2);          // 2 pixels
}

TEST(LayerSets, BentSkinNeedsMore) {
  const auto level = [](float curvature) { return layer_level(view, {{0, 0, 0}, tilted(0), 0.1f, curvature}); };
  EXPECT_EQ(level(0), 2);
  EXPECT_LT(level(10), level(7));
  EXPECT_EQ(level(100), 0);
}

TEST(LayerSets, UniformAndFewShellsAreOneSet) {
  LayerView few = view, uniform = view;
  few.shells = least_shells, uniform.policy = ShellPolicy::uniform;
  EXPECT_EQ(layer_level(few, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(layer_level(uniform, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(sets_of(least_shells, ShellPolicy::adaptive), 1);
  EXPECT_EQ(sets_of(1024, ShellPolicy::uniform), 1);
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
      EXPECT_TRUE(level >= 0 && level <= most_layer_sets - 1) << level;
    }
  }
}

Knobs knobs(int shells, int steps, int bands) { return {.shells = shells, .steps = steps, .bands = bands}; }

TEST(LayerSets, ShellsAndSteps) {
  EXPECT_EQ(sets_of(32, ShellPolicy::adaptive), 3);
  EXPECT_EQ(shells_of_set(32, 0), 32);
  EXPECT_EQ(shells_of_set(32, 1), 16);
  EXPECT_EQ(shells_of_set(32, 2), 8);
  EXPECT_EQ(sets_of(16, ShellPolicy::adaptive), 2);
  EXPECT_EQ(sets_of(12, ShellPolicy::adaptive), 2);
  EXPECT_EQ(shells_of_set(12, 1), 8);
  EXPECT_EQ(shells_of_set(1, 0), 1);
  EXPECT_EQ(steps_of_set(knobs(32, 4, 4), 0), (SlabSteps{1, 4}));
  EXPECT_EQ(steps_of_set(knobs(32, 4, 4), 1), (SlabSteps{2, 4}));
  EXPECT_EQ(steps_of_set(knobs(32, 4, 4), 2), (SlabSteps{4, 4}));
  EXPECT_EQ(steps_of_set(knobs(1, 1, 4), 0), (SlabSteps{1, 1}));
  EXPECT_EQ(steps_of_set(knobs(32, 4, 1), 2), (SlabSteps{1, 16}));
  EXPECT_EQ(steps_of_set(knobs(1024, 16, 4), 2), (SlabSteps{1, 16}));
}

TEST(LayerSets, EverySetIsMarkedWhereItMayShow) {
  const std::vector<glm::uvec3> triangles = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}};
  const std::vector<glm::vec3> centroids(3, glm::vec3(0)), normals = {{0, 0, 1}, {1, 0, -0.2f}, {0, 0, -1}};
  const auto lists_of = [&](std::vector<float> levels, int sets) {
    return sort_triangles({triangles, centroids, normals, levels}, view.eye, sets);
  };
  const LayerLists all = lists_of({0, 0.5f, 2}, 3);
  EXPECT_EQ(all.facing.size(), 1u);
  EXPECT_EQ(all.averted.size(), 1u);                             // the third is turned too far away
  for (const auto& marks : all.marks) EXPECT_EQ(marks.size(), 1u);  // corners from level 0 to 2
  const LayerLists two = lists_of({1, 0.6f, 1}, 3);
  EXPECT_EQ(two.marks[0].size(), 1u);  // dithered from .375 to .625
  EXPECT_EQ(two.marks[1].size(), 1u);
  EXPECT_EQ(two.marks[2].size(), 0u);
  EXPECT_EQ(lists_of({1, 0.7f, 1}, 3).marks[0].size(), 0u);
  EXPECT_EQ(lists_of({0, 0, 0}, 1).marks[0].size(), 0u);
  const std::vector<float> levels(3, 0.0f);
  EXPECT_EQ(shown_triangles({triangles, centroids, normals, levels}, view.eye).size(), 2u);
}

}  // namespace
}  // namespace pelage
