// Strands and body between a place and a light, against what is known of an even coat.
#include "renderer/raster/density_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/coat/strand_tile.h"
#include "renderer/raster/raster_optics.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

struct Lawn {
  FurPatch patch{0.5, 10, 0.08f};
  Coat coat = plain_coat(4000);
  GrownFur fur;

  Lawn() { fur.update(patch.model(), patch.fields(), {coat}, 2); }
};

FurLight from(glm::vec3 to_light) {
  FurLight light;
  light.direction = -glm::normalize(to_light);
  return light;
}

Crossed at(const DensityGrid& grid, glm::vec3 place, std::size_t light = 0) {
  const glm::ivec3 cell((place - grid.place().low) / grid.place().cell);
  return grid.crossed(light / 2)[grid.place().index(cell)][light % 2];
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
    EXPECT_NEAR(at(grid, {0.25, 0.25, height}).strands, above[slice] * longer, 0.15 * above[0] * longer) << height;
  }
  const double steeper = std::tan(std::atan(0.5));  // of 45 degrees' 1: width across over way up
  EXPECT_NEAR(at(grid, {0.25, 0.25, 0.012f}, 1).strands, above[4] * longer * steeper, 0.2 * above[4] * longer);
}

TEST(DensityGrid, NothingAboveTheFurIsInShadow) {
  const Lawn lawn;
  DensityGrid grid;
  grid.update(lawn.patch.model(), lawn.fur.parts(), std::vector{from({0, 0, 1})}, 1);
  EXPECT_NEAR(at(grid, {0.25, 0.25, 0.086f}).strands, 0, 1e-3);
  EXPECT_EQ(at(grid, {0.25, 0.25, 0.05f}).body, 0);  // the skin faces the light
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
  near.kind = LightKind::point, near.position = {0.2f, 0.3f, 0.05f};  // within the fur
  const std::vector<FurLight> lights{from({1, 0.3f, 0.5f}), near, from({-1, 0, 0})};
  DensityGrid one, many;
  one.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  many.update(lawn.patch.model(), lawn.fur.parts(), lights, 5);
  ASSERT_EQ(one.place(), many.place());
  for (std::size_t pair = 0; pair < 2; ++pair) {
    for (std::size_t i = 0; i < one.place().count(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(one.crossed(pair)[i][k].strands, many.crossed(pair)[i][k].strands);
        EXPECT_TRUE(std::isfinite(one.crossed(pair)[i][k].strands) && one.crossed(pair)[i][k].strands >= 0);
      }
    }
  }
}

TEST(DensityGrid, FollowsFurThatChanges) {
  Lawn lawn;
  const std::vector<FurLight> lights{from({1, 0, 1})};
  DensityGrid grid, fresh;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  std::fill(lawn.patch.length.begin(), lawn.patch.length.end(), 0.05f);
  lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), {lawn.coat}, 1);
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  fresh.update(lawn.patch.model(), lawn.fur.parts(), lights, 1);
  ASSERT_EQ(grid.place(), fresh.place());
  EXPECT_EQ(at(grid, {0.25, 0.25, 0.02f}).strands, at(fresh, {0.25, 0.25, 0.02f}).strands);
}

TEST(DensityGrid, TakesOutWhatWasThereToTheLastBit) {
  Lawn lawn;
  const std::vector<FurLight> lights{from({1, 0.2f, 1}), from({-0.3f, 1, 0.4f})};
  DensityGrid grid, fresh;
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  const GridPlace before = grid.place();
  for (std::size_t i = 36; i < 84; ++i) lawn.patch.length[i] = 0.05f;  // others stay as long
  ASSERT_GT(lawn.fur.update(lawn.patch.model(), lawn.patch.fields(), {lawn.coat}, 2), 0u);
  grid.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  fresh.update(lawn.patch.model(), lawn.fur.parts(), lights, 2);
  ASSERT_EQ(grid.place(), before) << "it is not made anew";
  ASSERT_EQ(grid.place(), fresh.place());
  for (std::size_t i = 0; i < grid.place().count(); ++i) {
    ASSERT_EQ(grid.density()[i].sum, fresh.density()[i].sum) << i;
    for (const std::size_t light : {0u, 1u}) {
      ASSERT_EQ(grid.crossed(0)[i][light].strands, fresh.crossed(0)[i][light].strands);
      ASSERT_EQ(grid.crossed(0)[i][light].body, fresh.crossed(0)[i][light].body);
    }
  }
}

}  // namespace
}  // namespace pelage
