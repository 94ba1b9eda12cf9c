// Grown fur grows again only where it has changed.
#include "renderer/strands/grown_fur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

std::vector<std::array<float, 4>> roots_of(const StrandSet& set) {
  std::vector<std::array<float, 4>> roots;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::vec3 position = knot(set, i, 0).position;
    roots.push_back({position.x, position.y, position.z, set.roots[i].number});
  }
  return roots;
}

TEST(GrownFur, HasTheStrandsOfOneGrower) {
  const FurPatch patch(0.6, 12);
  const GrowRecipe recipe{plain_coat()};
  GrownFur fur;
  const std::size_t grown = fur.update(patch.model(), patch.fields(), recipe, 2);
  EXPECT_EQ(grown, fur.count());
  ASSERT_GT(fur.parts().size(), 4u);
  std::vector<std::array<float, 4>> own, all = roots_of(patch.grow(recipe));
  for (const GrownPart& part : fur.parts()) {
    const auto roots = roots_of(*part.strands);
    own.insert(own.end(), roots.begin(), roots.end());
  }
  std::sort(own.begin(), own.end()), std::sort(all.begin(), all.end());
  EXPECT_EQ(own, all);
}

/// Two coats on a patch: long fur, and short fur on its left half alone.
struct TwoCoats {
  TwoCoats() {
    for (const glm::vec3 position : patch.positions) density.push_back(position.x < 0.3f ? 1.0f : 0.0f);
    for (std::size_t v = 0; v < patch.positions.size(); ++v) short_length.push_back(0.01f);
    recipes[1].coat.count /= 2, recipes[1].coat.seed = 9;
  }
  std::vector<FurFields> fields() const {
    FurFields shorter = patch.fields();
    shorter.length = short_length, shorter.paint.density = density, shorter.coat = 4;
    return {patch.fields(), shorter};
  }

  FurPatch patch{0.6, 12};
  std::vector<float> density, short_length;
  std::vector<GrowRecipe> recipes{2, GrowRecipe{plain_coat()}};
};

TEST(GrownFur, HasTheStrandsOfEachCoatAsIfItWereAlone) {
  const TwoCoats two;
  GrownFur both;
  both.update(two.patch.model(), two.fields(), two.recipes, 2);
  for (std::size_t c = 0; c < 2; ++c) {
    GrownFur alone;
    alone.update(two.patch.model(), two.fields()[c], two.recipes[c], 2);
    std::vector<std::array<float, 4>> of_both, of_alone;
    for (const GrownPart& part : both.parts()) {
      if (part.role != StrandRole::coat || part.coat != two.fields()[c].coat) continue;
      const auto roots = roots_of(*part.strands);
      of_both.insert(of_both.end(), roots.begin(), roots.end());
    }
    for (const GrownPart& part : alone.parts()) {
      const auto roots = roots_of(*part.strands);
      of_alone.insert(of_alone.end(), roots.begin(), roots.end());
    }
    std::sort(of_both.begin(), of_both.end()), std::sort(of_alone.begin(), of_alone.end());
    EXPECT_EQ(of_both, of_alone);
    EXPECT_GT(of_both.size(), 100u);
  }
}

TEST(GrownFur, OfOneCoatGrowsAgainWhereThatChanged) {
  TwoCoats two;
  GrownFur fur;
  fur.update(two.patch.model(), two.fields(), two.recipes, 2);
  EXPECT_EQ(fur.update(two.patch.model(), two.fields(), two.recipes, 2), 0u);
  two.short_length[0] = 0.02f;
  const std::vector<GrownPart> before = fur.parts();
  EXPECT_GT(fur.update(two.patch.model(), two.fields(), two.recipes, 2), 0u);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_TRUE(before[i].coat == 4 || fur.parts()[i].strands == before[i].strands);
}

TEST(GrownFur, SkinBetweenTwoCoatsIsUnderBoth) {
  TwoCoats two;
  two.recipes[0].coat.ramp = {{0, {1, 0, 0}}}, two.recipes[1].coat.ramp = {{0, {0, 0, 1}}};
  GrownFur fur;
  fur.update(two.patch.model(), two.fields(), two.recipes, 2);
  const std::size_t last = two.patch.triangles.size() - 1;  // on the right, where the second coat does not grow
  EXPECT_GT(fur.skin()[0][0].under.b, 0.2f);
  EXPECT_GT(fur.skin()[0][0].under.r, 0.2f);
  EXPECT_EQ(fur.skin()[last][2].under.b, 0);
}

TEST(GrownFur, OfWetterCoatsHasTheRestAsPainted) {
  TwoCoats two;
  FurFrame frame;
  frame.coats = {{"dry", 0, false, two.recipes[0].coat}, {"wet", 4, false, two.recipes[1].coat}};
  frame.coats[0].coat.wetness = 0.2, frame.coats[1].coat.wetness = 0.7;
  GrownFur fur;
  fur.update(two.patch.model(), two.fields(), recipes_of(frame, false, fur_area(two.patch.model())), 2);
  for (const GrownPart& part : fur.parts())
    for (const StrandRoot& root : part.strands->roots) ASSERT_NEAR(root.wetness, part.coat == 4 ? 0.5f : 0.0f, 1e-6f);
}

TEST(GrownFur, GrowsAgainOnlyWhatChanged) {
  FurPatch patch(0.6, 12);
  const GrowRecipe recipe{plain_coat()};
  GrownFur fur;
  fur.update(patch.model(), patch.fields(), recipe, 2);
  EXPECT_EQ(fur.update(patch.model(), patch.fields(), recipe, 2), 0u);
  const std::vector<GrownPart> before = fur.parts();
  patch.length[0] = 0.06f;  // in a corner
  const std::size_t grown = fur.update(patch.model(), patch.fields(), recipe, 2);
  EXPECT_GT(grown, 0u);
  EXPECT_LT(grown, fur.count() / 2);
  std::size_t unchanged = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool same = fur.parts()[i].strands == before[i].strands;
    EXPECT_EQ(same, fur.parts()[i].state == before[i].state);
    unchanged += same ? 1 : 0;
  }
  EXPECT_GT(unchanged, before.size() / 2);
}

/// A patch with all forms of fur that leans one way, and another way into which it has been moved.
struct BentPatch {
  BentPatch() : patch(0.6, 12) {
    recipe.coat = plain_coat();
    recipe.coat.length_spread = 0.4, recipe.coat.bend = 0.2, recipe.coat.curl = 0.1, recipe.coat.clump = 0.5;
    recipe.coat.tufts.gather = 0.5;
    recipe.guard_share = 0.2;
    for (std::size_t v = 0; v < patch.direction.size(); ++v) {
      const glm::vec3 position = patch.positions[v];
      patch.direction[v] = {0.5f * std::sin(9 * position.x), 0.3f * std::cos(7 * position.y)};
      moved.push_back(patch.direction[v] + glm::vec2(0.3f * std::cos(5 * position.x), 0.4f));
    }
  }
  FurFields fields() const {
    FurFields fields = patch.fields();
    fields.still = fields.direction, fields.direction = moved;
    return fields;
  }
  FurPatch patch;
  GrowRecipe recipe;
  std::vector<glm::vec2> moved;
};

TEST(GrownFur, WhatMovesItBendsItToWhereItWouldHaveGrown) {
  BentPatch bent;
  GrownFur fur, other;
  fur.update(bent.patch.model(), bent.fields(), bent.recipe, 2);
  bent.patch.direction = bent.moved;
  other.update(bent.patch.model(), bent.patch.fields(), bent.recipe, 2);
  ASSERT_EQ(fur.parts().size(), other.parts().size());
  float furthest = 0;
  for (std::size_t i = 0; i < fur.parts().size(); ++i) {
    const StrandSet &one = *fur.parts()[i].strands, &all = *other.parts()[i].strands;
    ASSERT_EQ(one.points.size(), all.points.size());
    for (std::size_t k = 0; k < one.points.size(); ++k)
      furthest = std::max(furthest, glm::distance(one.points[k].position, all.points[k].position));
    EXPECT_EQ(one.colours, all.colours);
    EXPECT_EQ(fur.parts()[i].longest, other.parts()[i].longest);
  }
  EXPECT_LT(furthest, 2e-6f) << "of fur of .03 sizes: roots are stored to 1/65535 of a triangle";
}

TEST(GrownFur, KnowsWhereItsPartsAreBentTo) {
  const BentPatch bent;
  GrownFur fur;
  fur.update(bent.patch.model(), bent.fields(), bent.recipe, 2);
  float beyond = 0;
  for (const GrownPart& part : fur.parts())
    for (const StrandPoint& point : part.strands->points)
      for (int axis = 0; axis < 3; ++axis)
        beyond = std::max({beyond, part.low[axis] - point.position[axis], point.position[axis] - part.high[axis]});
  EXPECT_LT(beyond, 1e-4f);
}

TEST(GrownFur, LeavesBendingToTheCaller) {
  const BentPatch bent;
  GrownFur fur, left, still;
  fur.update(bent.patch.model(), bent.fields(), bent.recipe, 2);
  left.update(bent.patch.model(), bent.fields(), bent.recipe, 2, {}, Bending::left);
  still.update(bent.patch.model(), bent.patch.fields(), bent.recipe, 2);
  EXPECT_EQ(left.bend().triangles.size(), bent.patch.triangles.size());
  EXPECT_TRUE(still.bend().triangles.empty());
  for (std::size_t i = 0; i < fur.parts().size(); ++i) {
    const GrownPart &one = fur.parts()[i], &other = left.parts()[i];
    EXPECT_EQ(one.low, other.low);
    EXPECT_EQ(one.high, other.high);
    const StrandSet &left_so = *other.strands, &grown = *still.parts()[i].strands;
    for (std::size_t k = 0; k < grown.points.size(); ++k)
      ASSERT_EQ(left_so.points[k].position, grown.points[k].position);
  }
  const std::vector<GrownPart> before = left.parts();
  left.update(bent.patch.model(), bent.fields(), bent.recipe, 2, {}, Bending::done);
  EXPECT_NE(left.parts().front().strands, before.front().strands) << "bent after all";
}

TEST(GrownFur, BendsAgainWhatStoodStill) {
  BentPatch bent;
  GrownFur fur;
  fur.update(bent.patch.model(), bent.patch.fields(), bent.recipe, 2);
  const std::vector<GrownPart> still = fur.parts();
  const std::size_t bytes = fur.bytes();
  EXPECT_EQ(fur.update(bent.patch.model(), bent.fields(), bent.recipe, 2), 0u) << "nothing grows";
  EXPECT_GT(fur.bytes(), bytes);
  const std::vector<GrownPart> first = fur.parts();
  for (glm::vec2& direction : bent.moved) direction += 0.1f;
  fur.update(bent.patch.model(), bent.fields(), bent.recipe, 2);
  for (std::size_t i = 0; i + 1 < still.size(); ++i) {
    EXPECT_NE(first[i].state, still[i].state);
    EXPECT_NE(fur.parts()[i].state, first[i].state);
    EXPECT_NE(fur.parts()[i].strands, first[i].strands);
  }
  EXPECT_EQ(fur.update(bent.patch.model(), bent.patch.fields(), bent.recipe, 2), 0u) << "at rest again";
  EXPECT_EQ(fur.bytes(), bytes);
  for (std::size_t i = 0; i < still.size(); ++i) EXPECT_EQ(fur.parts()[i].strands, still[i].strands);
}

TEST(GrownFur, CurvesAreAPartOfTheirOwn) {
  const FurPatch patch(0.6, 12);
  const GrowRecipe recipe{plain_coat()};
  GrownFur fur;
  fur.update(patch.model(), patch.fields(), recipe, 2);
  const std::size_t furred = fur.count();
  FurCurves brows;
  brows.guides = {{.points = {{0, 0, 0}, {0, 0, 1}}}, {.points = {{0.1, 0, 0}, {0.1, 0, 1}}}};
  EXPECT_EQ(fur.update(patch.model(), patch.fields(), recipe, 2, std::array{brows}), 2u);
  EXPECT_EQ(fur.count(), furred + 2);
  EXPECT_EQ(fur.parts().back().role, StrandRole::curve);
  EXPECT_EQ(fur.update(patch.model(), patch.fields(), recipe, 2, std::array{brows}), 0u);
  EXPECT_EQ(fur.update(patch.model(), patch.fields(), recipe, 2), 0u);
  EXPECT_EQ(fur.count(), furred);
}

TEST(GrownFur, KnowsWhereItsPartsAre) {
  const FurPatch patch(0.6, 12);
  GrownFur fur;
  fur.update(patch.model(), patch.fields(), GrowRecipe{plain_coat()}, 1);
  double area = 0;
  for (const GrownPart& part : fur.parts()) {
    if (part.role != StrandRole::coat) continue;
    area += part.area;
    EXPECT_NEAR(part.crowding, 1, 0.1f);
    EXPECT_EQ(part.longest, 0.03125f) << "the next step";
    for (const StrandPoint& point : part.strands->points) {
      EXPECT_TRUE(glm::all(glm::lessThanEqual(part.low, point.position)));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(part.high, point.position)));
    }
  }
  EXPECT_NEAR(area, 0.36, 1e-4);
}

}  // namespace
}  // namespace pelage
