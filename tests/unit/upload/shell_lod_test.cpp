#include "renderer/visibility/shell_lod.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "renderer/visibility/set_cells.h"

namespace pelage {
namespace {

const ShellView view{{0, 0, 10}, 0.0005f, 32, ShellPolicy::adaptive};

glm::vec3 tilted(float degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

TEST(ShellLods, MoreLayersTowardsTheSilhouette) {
  float last = 3;
  for (float degrees = 0; degrees <= 90; degrees += 1) {
    const float level = shell_lod_level(view, {{0, 0, 0}, tilted(degrees), 0.2f, 0});
    EXPECT_LE(level, last) << degrees;
    EXPECT_LT(last - level, degrees == 0 ? 2.0f : 0.15f) << "a jump at " << degrees;
    last = level;
  }
  EXPECT_EQ(shell_lod_level(view, {{0, 0, 0}, tilted(0), 0.2f, 0}), 2);
  EXPECT_EQ(last, 0);
}

TEST(ShellLods, FurThatIsSmallOnThePictureNeedsFew) {
  const glm::vec3 edge = tilted(89);
  EXPECT_EQ(shell_lod_level(view, {{0, 0, 0}, edge, 0.2f, 0}), 0);           // 40 pixels
  EXPECT_NEAR(shell_lod_level(view, {{0, 0, 0}, edge, 0.08f, 0}), 1, 0.01);  // 16 pixels
  EXPECT_EQ(shell_lod_level(view, {{0, 0, 0}, edge, 0.02f, 0}), 2);          // 4 pixels
}

TEST(ShellLods, BentSkinNeedsMore) {
  const auto level = [](float curvature) { return shell_lod_level(view, {{0, 0, 0}, tilted(0), 0.2f, curvature}); };
  EXPECT_EQ(level(0), 2);
  EXPECT_LT(level(5), level(4));
  EXPECT_EQ(level(100), 0);
}

TEST(ShellLods, UniformAndFewShellsAreOneSet) {
  ShellView few = view, uniform = view;
  few.shells = min_shells, uniform.policy = ShellPolicy::uniform;
  EXPECT_EQ(shell_lod_level(few, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(shell_lod_level(uniform, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(sets_of(min_shells, ShellPolicy::adaptive), 1);
  EXPECT_EQ(sets_of(1024, ShellPolicy::uniform), 1);
}

TEST(ShellLods, CurvatureOfASphereIsOneOverItsRadius) {
  std::vector<glm::vec3> normals;
  std::vector<glm::uvec3> triangles;
  for (int row = 1; row < 40; ++row) {
    for (int column = 0; column < 80; ++column) {
      const float polar = 3.14159265f * static_cast<float>(row) / 40,
                  turn = 3.14159265f * static_cast<float>(column) / 40;
      normals.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
    }
  }
  std::vector<glm::vec3> positions;
  for (const glm::vec3& n : normals) positions.push_back(0.25f * n);
  for (std::uint32_t i = 0; i + 80 < normals.size(); ++i) triangles.emplace_back(i, i + 1, i + 80);
  for (const float curvature : curvatures(positions, normals, triangles)) EXPECT_NEAR(curvature, 4, 1e-3);
}

TEST(ShellLods, ExtremesAreLevels) {
  for (const float length : {0.0f, 1e-20f, 10.0f, 1e20f}) {
    for (const glm::vec3 place : {glm::vec3(0, 0, 10), glm::vec3(0, 0, 1e6f), glm::vec3(0)}) {
      const float level = shell_lod_level(view, {place, {0, 0, 1}, length, 1e6f});
      EXPECT_TRUE(level >= 0 && level <= max_shell_lods - 1) << level;
    }
  }
}

Knobs knobs(int shells, int steps) { return {.shells = shells, .steps = steps}; }

TEST(ShellLods, ShellsAndSteps) {
  EXPECT_EQ(sets_of(32, ShellPolicy::adaptive), 3);
  EXPECT_EQ(shells_of_set(32, 0), 32);
  EXPECT_EQ(shells_of_set(32, 1), 16);
  EXPECT_EQ(shells_of_set(32, 2), 8);
  EXPECT_EQ(sets_of(16, ShellPolicy::adaptive), 2);
  EXPECT_EQ(sets_of(12, ShellPolicy::adaptive), 2);
  EXPECT_EQ(shells_of_set(12, 1), 8);
  EXPECT_EQ(shells_of_set(1, 0), 1);
  EXPECT_EQ(steps_of_set(knobs(32, 4), 0), 4);
  EXPECT_EQ(steps_of_set(knobs(32, 4), 1), 8);
  EXPECT_EQ(steps_of_set(knobs(32, 4), 2), 16);
  EXPECT_EQ(steps_of_set(knobs(1, 1), 0), 1);
  EXPECT_EQ(steps_of_set(knobs(32, 4), 2), 16);
  EXPECT_EQ(steps_of_set(knobs(1024, 16), 2), 16);
}

/// Three triangles of three vertices each about `places`: one that is front-facing, one turned a little away, one far.
struct ThreeTriangles {
  std::vector<glm::uvec3> triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  std::vector<glm::vec3> centroids = std::vector<glm::vec3>(3, glm::vec3(0));
  std::vector<glm::vec3> normals = {{0, 0, 1}, {1, 0, -0.2f}, {0, 0, -1}};
  std::vector<glm::vec3> positions = std::vector<glm::vec3>(9, glm::vec3(0));
  std::vector<float> lengths = std::vector<float>(9, 0.01f);

  ShellLists sorted(std::array<float, 3> levels, int shells) const {
    std::vector<float> all;
    for (int i = 0; i < 3; ++i) all.insert(all.end(), levels.begin(), levels.end());
    ShellView seen = view;
    seen.shells = shells;
    seen.to_clip[3] = {0, 0, 0, 10};  // straight on, from 10 away
    const std::vector<CellBox> cells = cells_of_fur(seen.to_clip, positions, lengths);
    return sort_triangles({triangles, centroids, normals, positions, lengths, all, cells}, seen);
  }
};

TEST(ShellLods, EverySetIsMarkedWhereItMayShow) {
  const ThreeTriangles mesh;
  const ShellLists all = mesh.sorted({0, 0.5f, 2}, 32);
  for (const auto& marks : all.marks) EXPECT_EQ(marks.size(), 1u);  // corners from level 0 to 2
  const ShellLists two = mesh.sorted({1, 0.6f, 1}, 32);
  EXPECT_EQ(two.marks[0].size(), 1u);  // dithered from .375 to .625
  EXPECT_EQ(two.marks[1].size(), 1u);
  EXPECT_EQ(two.marks[2].size(), 0u);
  EXPECT_EQ(mesh.sorted({1, 0.7f, 1}, 32).marks[0].size(), 0u);
  EXPECT_EQ(mesh.sorted({0, 0, 0}, 8).marks[0].size(), 0u);
  const std::vector<float> levels(9, 0.0f);
  const std::vector<CellBox> cells(9);
  EXPECT_EQ(
      shown_triangles({mesh.triangles, mesh.centroids, mesh.normals, mesh.positions, mesh.lengths, levels, cells}, view)
          .size(),
      2u);
}

TEST(ShellLods, ASetIsDrawnWhereItMayBeAskedForAndNowhereElse) {
  ThreeTriangles mesh;
  const ShellLists together = mesh.sorted({2, 2, 2}, 32);
  EXPECT_EQ(together.facing[2].size(), 1u);
  EXPECT_EQ(together.facing[0].size(), 1u);  // the one that turns away leaves pixels without a mark beside it
  EXPECT_EQ(together.back_facing[0].size(), 1u);
  EXPECT_EQ(together.back_facing[2].size(), 1u);
  EXPECT_EQ(together.facing[1].size() + together.back_facing[1].size(), 0u);
  for (std::size_t i = 3; i < 6; ++i) mesh.positions[i] = {8, 0, 0};
  const ShellLists apart = mesh.sorted({2, 2, 2}, 32);
  EXPECT_EQ(apart.facing[0].size(), 0u);
  EXPECT_EQ(apart.back_facing[2].size(), 0u);
  EXPECT_EQ(apart.back_facing[0].size(), 1u);
  const ShellLists one = mesh.sorted({0, 0, 0}, 8);
  EXPECT_EQ(one.facing[0].size(), 1u);
  EXPECT_EQ(one.back_facing[0].size(), 1u);
}

TEST(ShellLods, TrianglesOutsideThePictureAreNotDrawn) {
  for (const float side : {-1.0f, 1.0f}) {
    for (const int shells : {8, 32}) {  // one set, and three
      ThreeTriangles mesh;
      for (std::size_t i = 0; i < 3; ++i) mesh.positions[i] = {12 * side, 0, 0};  // 10 is the border
      EXPECT_EQ(mesh.sorted({0, 0, 0}, shells).facing[0].size(), 0u) << shells;
      EXPECT_EQ(mesh.sorted({0, 0, 0}, shells).back_facing[0].size(), 1u) << shells;
      mesh.positions[2] = {9 * side, 0, 0};  // it reaches in
      EXPECT_EQ(mesh.sorted({0, 0, 0}, shells).facing[0].size(), 1u) << shells;
      for (std::size_t i = 0; i < 3; ++i) mesh.positions[i] = {10.005f * side, 0, 0};  // its fur, .01 long, reaches in
      EXPECT_EQ(mesh.sorted({0, 0, 0}, shells).facing[0].size(), 1u) << shells;
    }
  }
}

TEST(SetCells, WhatLiesBesideThePictureTouchesNothingOfIt) {
  const CellBox picture;
  for (const glm::vec2 away : {glm::vec2(-3, 0), glm::vec2(3, 0), glm::vec2(0, -3), glm::vec2(0, 3)}) {
    const CellBox box = cells_of(ClipBox{away - 0.5f, away + 0.5f});
    EXPECT_FALSE(touch(box, picture));
    SetCells cells;
    cells.show(box, 0);
    EXPECT_FALSE(cells.may_show(picture, 0));
    EXPECT_TRUE(touch(cells_of(ClipBox{away - 2.1f, away + 2.1f}), picture));
  }
  EXPECT_EQ(cells_of(ClipBox{}), picture);
  EXPECT_EQ(cells_of(ClipBox{glm::vec2(-1e30f), glm::vec2(1e30f)}), (CellBox{-1, -1, cells_a_side, cells_a_side}));
}

TEST(SetCells, FurNearTheEyeMayBeEverywhere) {
  const glm::mat4 to_clip(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0);  // w = z
  const std::vector<glm::vec3> places = {{0, 0, 1}, {0, 0, 0.1f}, {0, 0, -1}, {1e20f, 0, 1e-20f}};
  const std::vector<CellBox> boxes = cells_of_fur(to_clip, places, std::vector<float>(4, 0.2f));
  EXPECT_GT(boxes[0].left, 0);
  EXPECT_LT(boxes[0].right, cells_a_side - 1);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(boxes[i], CellBox()) << i;
  }
}

}  // namespace
}  // namespace pelage
