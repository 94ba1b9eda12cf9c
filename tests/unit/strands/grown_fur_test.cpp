// Fur that grows again only where it changed.
#include "renderer/strands/grown_fur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

std::vector<std::array<float, 4>> roots_of(const StrandSet& set) {
  std::vector<std::array<float, 4>> roots;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::vec3 place = knot(set, i, 0).place;
    roots.push_back({place.x, place.y, place.z, set.roots[i].number});
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
  std::size_t kept = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool same = fur.parts()[i].strands == before[i].strands;
    EXPECT_EQ(same, fur.parts()[i].state == before[i].state);
    kept += same ? 1 : 0;
  }
  EXPECT_GT(kept, before.size() / 2);
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
  fur.update(patch.model(), patch.fields(), {plain_coat()}, 1);
  double area = 0;
  for (const GrownPart& part : fur.parts()) {
    if (part.role != StrandRole::coat) continue;
    area += part.area;
    EXPECT_NEAR(part.crowding, 1, 0.1f);
    EXPECT_EQ(part.longest, 0.03125f) << "the next step";
    for (const StrandPoint& point : part.strands->points) {
      EXPECT_TRUE(glm::all(glm::lessThanEqual(part.low, point.place)));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(part.high, point.place)));
    }
  }
  EXPECT_NEAR(area, 0.36, 1e-4);
}

}  // namespace
}  // namespace pelage
