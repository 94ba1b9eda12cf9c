#include "renderer/upload/shell_lod.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pelage {
namespace {

const ShellView view{{0, 0, 10}, 0.0005f, 32, ShellPolicy::adaptive};

glm::vec3 tilted(float degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

TEST(ShellLods, MoreShellsTowardsTheSilhouette) {
  float last = 3;
  for (float degrees = 0; degrees <= 90; degrees += 1) {
    const float level = shell_lod(view, {{0, 0, 0}, tilted(degrees), 0.2f, 0});
    EXPECT_LE(level, last) << degrees;
    EXPECT_LT(last - level, degrees == 0 ? 2.0f : 0.15f) << "a jump at " << degrees;
    last = level;
  }
  EXPECT_EQ(shell_lod(view, {{0, 0, 0}, tilted(0), 0.2f, 0}), 2);
  EXPECT_EQ(last, 0);
}

TEST(ShellLods, FurThatIsSmallOnThePictureNeedsFew) {
  const glm::vec3 edge = tilted(89);
  EXPECT_EQ(shell_lod(view, {{0, 0, 0}, edge, 0.2f, 0}), 0);           // 40 pixels
  EXPECT_NEAR(shell_lod(view, {{0, 0, 0}, edge, 0.08f, 0}), 1, 0.01);  // 16 pixels
  EXPECT_EQ(shell_lod(view, {{0, 0, 0}, edge, 0.02f, 0}), 2);          // 4 pixels
}

TEST(ShellLods, BentSkinNeedsMore) {
  const auto level = [](float curvature) { return shell_lod(view, {{0, 0, 0}, tilted(0), 0.2f, curvature}); };
  EXPECT_EQ(level(0), 2);
  EXPECT_LT(level(5), level(4));
  EXPECT_EQ(level(100), 0);
}

TEST(ShellLods, UniformAndFewShellsAreNotHalved) {
  ShellView few = view, uniform = view;
  few.shells = min_shells, uniform.policy = ShellPolicy::uniform;
  EXPECT_EQ(shell_lod(few, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(shell_lod(uniform, {{0, 0, 0}, tilted(0), 0.1f, 0}), 0);
  EXPECT_EQ(max_lod(min_shells, ShellPolicy::adaptive), 0);
  EXPECT_EQ(max_lod(1024, ShellPolicy::uniform), 0);
  EXPECT_EQ(max_lod(1024, ShellPolicy::adaptive), max_shell_lod);
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

TEST(ShellLods, ExtremesGiveValidLevels) {
  for (const float length : {0.0f, 1e-20f, 10.0f, 1e20f}) {
    for (const glm::vec3 position : {glm::vec3(0, 0, 10), glm::vec3(0, 0, 1e6f), glm::vec3(0)}) {
      const float level = shell_lod(view, {position, {0, 0, 1}, length, 1e6f});
      EXPECT_TRUE(level >= 0 && level <= max_shell_lod) << level;
    }
  }
}

TEST(ShellLods, AtLeastTheFewestAreLeft) {
  for (int shells = 1; shells <= 64; ++shells) {
    const int lod = max_lod(shells, ShellPolicy::adaptive);
    int left = 0;
    for (int shell = 0; shell < shells; ++shell) left += gone_from(shell) > lod;
    EXPECT_GE(left, std::min(shells, min_shells)) << shells;
    EXPECT_LT(lod < max_shell_lod ? shells >> (lod + 1) : 0, min_shells) << shells;
  }
}

TEST(ShellLods, SlabsFillTheHeightAtAnyLevel) {
  for (const int shells : {8, 16, 18, 19, 32, 1024}) {
    for (float lod = 0; lod <= max_shell_lod; lod += 0.125f) {
      EXPECT_EQ(slab_begin(0, shells, lod), 0);
      EXPECT_EQ(slab_begin(shells, shells, lod), shells);
      for (int shell = 0; shell < shells; ++shell) {
        const float thickness = slab_begin(shell + 1, shells, lod) - slab_begin(shell, shells, lod);
        if (lod >= static_cast<float>(gone_from(shell)))
          EXPECT_EQ(thickness, 0) << shell << " of " << shells << " at " << lod;
        else if (shells % 4 == 0)
          EXPECT_GT(thickness, 0) << shell << " of " << shells << " at " << lod;
        else  // the last shells have less room to move into
          EXPECT_GE(thickness, 0) << shell << " of " << shells << " at " << lod;
      }
    }
  }
  EXPECT_EQ(slab_begin(3, 8, 0.25f), 3.25f);
  EXPECT_EQ(slab_begin(3, 8, 1.5f), 4);
  EXPECT_EQ(slab_begin(2, 8, 1.5f), 3);
}

/// Three triangles of three vertices each: one front-facing, one slightly back-facing, one that faces straight away.
struct ThreeTriangles {
  std::vector<glm::uvec3> triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  std::vector<glm::vec3> centroids = std::vector<glm::vec3>(3, glm::vec3(0));
  std::vector<glm::vec3> normals = {{0, 0, 1}, {1, 0, -0.2f}, {0, 0, -1}};
  std::vector<glm::vec3> positions = std::vector<glm::vec3>(9, glm::vec3(0));

  ShellLists sorted(std::array<float, 3> lods, int shells) const {
    std::vector<float> all;
    for (int i = 0; i < 3; ++i) all.insert(all.end(), lods.begin(), lods.end());
    ShellView seen = view;
    seen.shells = shells;
    return sort_triangles({triangles, centroids, normals, positions, all}, seen);
  }
};

TEST(ShellLods, ShellsAreDrawnWhereTheyHaveNotGone) {
  const ThreeTriangles mesh;
  const auto counts = [&](std::array<float, 3> lods, int shells) {
    const ShellLists lists = mesh.sorted(lods, shells);
    std::array<std::size_t, 3> facing{}, back_facing{};
    for (std::size_t i = 0; i < 3; ++i)
      facing[i] = lists.facing[i].size(), back_facing[i] = lists.back_facing[i].size();
    EXPECT_EQ(facing, back_facing);  // one triangle of each is drawn
    return facing;
  };
  using Counts = std::array<std::size_t, 3>;
  EXPECT_EQ(counts({0, 0.5f, 2}, 32), (Counts{1, 1, 1}));
  EXPECT_EQ(counts({1, 1.5f, 2}, 32), (Counts{0, 1, 1}));
  EXPECT_EQ(counts({2, 2, 2}, 32), (Counts{0, 0, 1}));
  EXPECT_EQ(counts({1, 1, 1}, 16), (Counts{0, 1, 0}));  // halved at most once
  EXPECT_EQ(counts({0, 0, 0}, 8), (Counts{1, 0, 0}));
}

}  // namespace
}  // namespace pelage
