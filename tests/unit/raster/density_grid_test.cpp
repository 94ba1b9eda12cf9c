// Strands and body between a point and a light, against known values of an even coat.
#include "renderer/raster/density_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "renderer/coat/strand_tile.h"
#include "renderer/raster/raster_optics.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

struct Lawn {
  FurPatch patch{0.5, 10, 0.08f};
  Coat coat = plain_coat(4000);
  GrownFur fur;

  Lawn() { fur.update(patch.model(), patch.fields(), GrowRecipe{coat}, 2); }
};

FurLight from(glm::vec3 to_light) {
  FurLight light;
  light.direction = -glm::normalize(to_light);
  return light;
}

struct CrossedNumbers {
  float strands, body;
};

CrossedNumbers at(const DensityGrid& grid, glm::vec3 position, std::size_t light = 0) {
  const glm::ivec3 cell((position - grid.layout().low) / grid.layout().cell);
  const Crossed& crossed = grid.crossed(light)[grid.layout().index(cell)];
  return {static_cast<float>(crossed.strands) / Crossed::one, static_cast<float>(crossed.body) / Crossed::one};
}

struct Spread {
  double mean, deviation;
};

/// Mean and deviation of the strands crossed towards a light, over cells in the middle of the lawn.
Spread spread_at(const DensityGrid& grid, float height, std::size_t light = 0) {
  double sum = 0, squares = 0;
  int count = 0;
  for (float x = 0.15f; x < 0.35f; x += 0.008f) {
    for (float y = 0.15f; y < 0.35f; y += 0.008f, ++count) {
      const double strands = at(grid, {x, y, height}, light).strands;
      sum += strands, squares += strands * strands;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

/// Number of cells that differ.
std::size_t others(std::span<const Crossed> a, std::span<const Crossed> b) {
  if (a.size() != b.size()) return std::max(a.size(), b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return count;
}

TEST(DensityGrid, LightFromTheSideCrossesWhatTheCoatHasAbove) {
  const Lawn lawn;
  const std::vector<FurLight> lights{from({1, 0, 1}), from({0, -1, 2})};
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  const auto above = strands_above(lawn.coat);
  const double longer = 0.08 / nominal_length;
  for (const float height : {0.012f, 0.028f, 0.044f}) {
    const auto slice = static_cast<std::size_t>(height / 0.08f * slice_count);
    const Spread spread = spread_at(grid, height);
    EXPECT_NEAR(spread.mean, above[slice] * longer, 0.15 * above[0] * longer) << height;
    EXPECT_LT(spread.deviation, 0.1 * spread.mean) << height;
  }
  const double steeper = std::tan(std::atan(0.5));  // path across over that at 45 degrees
  EXPECT_NEAR(spread_at(grid, 0.012f, 1).mean, above[4] * longer * steeper, 0.2 * above[4] * longer);
}

TEST(DensityGrid, NothingAboveTheFurIsInShadow) {
  const Lawn lawn;
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), std::vector{from({0, 0, 1})}, 1);
  EXPECT_NEAR(at(grid, {0.25, 0.25, 0.086f}).strands, 0, 1e-3);
  EXPECT_EQ(at(grid, {0.25, 0.25, 0.05f}).body, 0);  // the skin faces the light and does not occlude it
}

TEST(DensityGrid, SkinStopsLightFromBehind) {
  const Lawn lawn;
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), std::vector{from({0.2f, 0, -1})}, 1);
  EXPECT_GT(at(grid, {0.25, 0.25, 0.05f}).body, 3);
}

TEST(DensityGrid, HasTheSameBitsForAnyThreads) {
  const Lawn lawn;
  FurLight near;
  near.kind = LightKind::point, near.position = {0.2f, 0.3f, 0.05f};  // inside the fur
  const std::vector<FurLight> lights{from({1, 0.3f, 0.5f}), near, from({-1, 0, 0})};
  DensityGrid one, many;
  one.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  many.update(lawn.patch.model(), lawn.fur.parts(), lights, 5);
  ASSERT_EQ(one.layout(), many.layout());
  for (std::size_t light = 0; light < lights.size(); ++light) {
    EXPECT_EQ(others(one.crossed(light), many.crossed(light)), 0u);
    EXPECT_GT(others(one.crossed(light), std::vector<Crossed>(one.layout().count())), 0u) << "something is crossed";
  }
}

TEST(DensityGrid, FollowsFurThatChanges) {
  Lawn lawn;
  const std::vector<FurLight> lights{from({1, 0, 1})};
  DensityGrid grid, fresh;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  std::fill(lawn.patch.length.begin(), lawn.patch.length.end(), 0.05f);
  lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), GrowRecipe{lawn.coat}, 1);
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  fresh.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  ASSERT_EQ(grid.layout(), fresh.layout());
  EXPECT_EQ(at(grid, {0.25, 0.25, 0.02f}).strands, at(fresh, {0.25, 0.25, 0.02f}).strands);
}

TEST(DensityGrid, ChangeByChangeHasTheBitsOfANewOne) {
  Lawn lawn;
  FurLight near;
  near.kind = LightKind::point, near.position = {0.2f, 0.9f, 0.5f};
  FurLight within = near;
  within.position = {0.213f, 0.277f, 0.021f};
  const std::vector<FurLight> lights{from({1, 0.2f, 1}),
                                     from({-0.3f, 1, 0.4f}),
                                     from({1, 0.3f, 0.2f}),
                                     from({-1, 0.05f, -0.6f}),
                                     from({0, 0, 1}),
                                     near,
                                     within};
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  const GridLayout before = grid.layout();
  struct Change {
    std::size_t first, count;
    float length;
  };
  for (const auto& [first, count, length] : {Change{36, 9, 0.05f}, {70, 9, 0.05f}, {37, 9, 0.05f}, {0, 119, 0.04f}}) {
    for (std::size_t i = first; i < first + count; ++i) lawn.patch.length[i] = length;  // other fur keeps its length
    ASSERT_GT(lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), GrowRecipe{lawn.coat}, 2), 0u);
    grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
    DensityGrid fresh;
    fresh.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
    ASSERT_EQ(grid.layout(), before) << "it stays where it is";
    ASSERT_EQ(grid.layout(), fresh.layout());
    for (std::size_t i = 0; i < grid.layout().count(); ++i) ASSERT_EQ(grid.density()[i].sum, fresh.density()[i].sum);
    for (std::size_t light = 0; light < lights.size(); ++light)
      EXPECT_EQ(others(grid.crossed(light), fresh.crossed(light)), 0u) << "light " << light;
  }
}

TEST(DensityGrid, KnowsWhereSomethingHasChanged) {
  Lawn lawn;
  lawn.patch.length.assign(lawn.patch.length.size(), 0.03f);
  lawn.patch.length.front() = 0.08f;  // keeps the extent of the grid
  lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), GrowRecipe{lawn.coat}, 2);
  const std::vector<FurLight> lights{from({0, 0, 1})};
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  EXPECT_TRUE(grid.all_changed(0));
  const std::uint64_t since = grid.version();
  const glm::vec3 corner{0.45f, 0.45f, 0.01f}, other{0.05f, 0.4f, 0.01f}, little(0.01f);
  lawn.patch.length.back() = 0.06f;
  lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), GrowRecipe{lawn.coat}, 2);
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  EXPECT_FALSE(grid.all_changed(since));
  EXPECT_TRUE(grid.changed_in(corner, corner + little, since));
  EXPECT_FALSE(grid.changed_in(other, other + little, since));
  EXPECT_FALSE(grid.changed_in(corner, corner + little, grid.version()));
  const std::vector<GridBlock> blocks = grid.changed_blocks(since);
  const auto has = [&](glm::vec3 position) {
    return std::any_of(blocks.begin(), blocks.end(), [&](const GridBlock& block) {
      return glm::all(glm::lessThanEqual(block.low, position)) && glm::all(glm::lessThan(position, block.high));
    });
  };
  EXPECT_TRUE(has({0.48f, 0.48f, 0.05f}));
  EXPECT_FALSE(has(other));
  EXPECT_TRUE(grid.changed_blocks(grid.version()).empty());
}

// A draft mixes the mean colour into each strand.
TEST(DensityGrid, StrandsWhoseMeanHasAnotherColourHaveChanged) {
  const Lawn lawn;
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), {}, 1);
  const std::uint64_t since = grid.version();
  std::vector<GrownPart> parts = lawn.fur.parts();
  StrandSet set = *parts[0].strands;
  set.to_mean[5] = pack_colour({1, 0, 0});
  parts[0].strands = std::make_shared<const StrandSet>(set), ++parts[0].state;
  grid.update(lawn.patch.model(), parts, {}, 1);
  EXPECT_FALSE(grid.all_changed(since));
  const glm::vec3 root = set.points[5 * (static_cast<std::size_t>(set.segments) + 1)].position;
  EXPECT_TRUE(grid.changed_in(root, root + 1e-4f, since));
}

}  // namespace
}  // namespace pelage
