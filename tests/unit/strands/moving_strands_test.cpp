// Strands that move while the shutter is open.
#include <gtest/gtest.h>

#include "renderer/strands/world.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

constexpr std::size_t plenty = std::size_t{1} << 30;

/// A patch of fur that is upright when the shutter opens, and leans along x by half when it closes.
struct MovingPatch {
  FurPatch patch{0.12};
  std::vector<glm::vec2> closing;

  MovingPatch() { closing.assign(patch.positions.size(), {0.5f, 0}); }
  FurFields fields() const {
    FurFields fields = patch.fields();
    fields.closing = closing;
    return fields;
  }
  StrandSet grow(const GrowRecipe& recipe) const { return Grower(patch.model(), fields(), recipe).grow(patch.all()); }
};

Coat few_thick_strands() {
  Coat coat = plain_coat(40);
  coat.width_root = coat.width_tip = 0.002;
  return coat;
}

TEST(MovingStrands, StartAsTheyOpenAndEndAsTheyClose) {
  for (const double guard_share : {0.0, 1.0}) {
    const GrowRecipe recipe{.coat = few_thick_strands(), .guard_share = guard_share};
    MovingPatch moving;
    const StrandSet both = moving.grow(recipe), opening = moving.patch.grow(recipe);
    moving.patch.direction = moving.closing;
    const StrandSet closing = moving.patch.grow(recipe);
    ASSERT_GT(both.count(), 10u);
    ASSERT_EQ(both.closing.size(), both.points.size());
    ASSERT_EQ(opening.points.size(), both.points.size());
    EXPECT_TRUE(opening.closing.empty());
    for (std::size_t i = 0; i < both.points.size(); ++i) {
      EXPECT_EQ(both.points[i].position, opening.points[i].position);
      EXPECT_EQ(both.closing[i].position, closing.points[i].position);
      EXPECT_EQ(both.closing[i].radius, both.points[i].radius);
    }
    EXPECT_GT(both.closing.back().position.x, both.points.back().position.x + 0.01f);
    EXPECT_GT(both.bytes(), opening.bytes());
  }
}

TEST(MovingStrands, RaysHitThemWhereTheyAreAtTheirTime) {
  const MovingPatch moving;
  const GrowRecipe recipe{few_thick_strands()};
  World world(plenty);
  ASSERT_TRUE(world.update(moving.patch.model(), moving.fields(), FurFrame{}, recipe, {1, false}, [] { return true; }));
  const StrandSet set = moving.grow(recipe);
  int hits = 0;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const std::size_t at = i * static_cast<std::size_t>(set.segments + 1) + static_cast<std::size_t>(set.segments) / 2;
    for (const float time : {0.0f, 0.5f, 1.0f}) {
      const glm::vec3 position = glm::mix(set.points[at].position, set.closing[at].position, time);
      const Ray ray{.origin = position - glm::vec3(0, 0.005f, 0), .direction = {0, 1, 0}, .t_max = 0.01f, .time = time};
      const Hit hit = world.intersect(ray);
      hits += hit.kind == HitKind::strand && std::abs(hit.distance - 0.005f) < 5e-4f;
      EXPECT_TRUE(world.occluded(ray));
      EXPECT_LT(world.transmittance(ray, 1).r, 0.9f);
      if (hit.strand.strand != i) continue;
      EXPECT_NEAR(hit.tangent.x, 0.25f * time, time > 0 ? 0.2f : 1e-3f);
    }
  }
  EXPECT_GE(hits, 2.8 * static_cast<double>(set.count()));
}

TEST(MovingStrands, AreGrownAnewWhenTheyMoveElsewhere) {
  MovingPatch moving;
  const GrowRecipe recipe{few_thick_strands()};
  World world(plenty);
  const auto update = [&](const FurFields& fields) {
    return world.update(moving.patch.model(), fields, FurFrame{}, recipe, {1, false}, [] { return true; })->grown;
  };
  EXPECT_GT(update(moving.patch.fields()), 0u);
  EXPECT_GT(update(moving.fields()), 0u);
  EXPECT_EQ(update(moving.fields()), 0u);
  moving.closing.assign(moving.closing.size(), {0, 0.5f});
  EXPECT_GT(update(moving.fields()), 0u);
  EXPECT_GT(update(moving.patch.fields()), 0u);
}

}  // namespace
}  // namespace pelage
