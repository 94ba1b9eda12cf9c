#include "server/fields/field_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "protocol/base/random.h"

namespace pelage {
namespace {

Groom groom(float x, float y, float length, float stretch = 0) { return {{x, y}, length, stretch}; }

TEST(FieldSet, HashDependsOnEachBitAndPlaceButNotOnTheWay) {
  FieldSet fields(100);
  const FieldsHash empty = fields.hash();
  fields.set(7, groom(0.5f, 0, 0.1f));
  const FieldsHash one = fields.hash();
  EXPECT_NE(one, empty);
  fields.set(7, {});
  EXPECT_EQ(fields.hash(), empty);
  fields.set(8, groom(0.5f, 0, 0.1f));
  EXPECT_NE(fields.hash(), one);
  fields.set(8, groom(0, 0.5f, 0.1f));
  EXPECT_NE(fields.hash(), one);
  FieldSet forwards(3), backwards(3);
  for (std::uint32_t v = 0; v < 3; ++v) forwards.set(v, groom(0.1f * v, 0, 1));
  for (std::uint32_t v = 3; v-- > 0;) backwards.set(v, groom(0.1f * v, 0, 1));
  EXPECT_EQ(forwards.hash(), backwards.hash());
  EXPECT_NE(FieldSet(3).hash(), FieldSet(4).hash());
}

TEST(FieldSet, HashTellsFieldsApart) {
  FieldSet length(1), stretch(1);
  length.set(0, groom(0, 0, 0.5f, 0));
  stretch.set(0, groom(0, 0, 0, 0.5f));
  EXPECT_NE(length.hash(), stretch.hash());
}

TEST(FieldSet, StoresNoNegativeZero) {
  FieldSet fields(1);
  const FieldsHash zero = fields.hash();
  fields.set(0, groom(-0.0f, -0.0f, -0.0f, -0.0f));
  EXPECT_EQ(fields.hash(), zero);
  EXPECT_FALSE(std::signbit(fields.at(0).direction.x));
}

TEST(FieldSet, HashAfterIsWhatApplyingGives) {
  FieldSet fields(10), other(10);
  other.set(3, groom(0.3f, 0.1f, 2));
  other.set(9, groom(0, 0.1f, 1, 4));
  const FieldDelta delta = difference(fields, other);
  EXPECT_EQ(fields.hash_after(delta), other.hash());
  fields.apply(delta);
  EXPECT_EQ(fields.hash(), other.hash());
  fields.apply(inverse(delta));
  EXPECT_EQ(fields.hash(), FieldSet(10).hash());
}

TEST(StoredGroom, IsNeverLongerThanOneAndStaysWhenStoredAgain) {
  Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const double angle = random.uniform(0, 7), length = i % 2 == 0 ? 1 : random.uniform(0, 2);
    const Groom stored = stored_groom(length * glm::dvec2(std::cos(angle), std::sin(angle)), 1, 0);
    const glm::dvec2 direction(stored.direction);
    ASSERT_LE(glm::dot(direction, direction), 1.0);
    ASSERT_NEAR(glm::length(direction), std::min(length, 1.0), 4e-7);
    ASSERT_EQ(stored_groom(direction, 1, 0), stored);
  }
}

TEST(FieldDelta, ComposeKeepsEndsAndDropsReturns) {
  const FieldDelta first{{1, 4}, {groom(0, 0, 1), groom(0, 0, 2)}, {groom(0, 0, 3), groom(0, 0, 4)}};
  const FieldDelta second{{4, 6}, {groom(0, 0, 4), groom(0, 0, 5)}, {groom(0, 0, 2), groom(0, 0, 6)}};
  const FieldDelta both = compose(first, second);
  EXPECT_EQ(both.vertices, (std::vector<std::uint32_t>{1, 6}));
  EXPECT_EQ(both.before, (std::vector<Groom>{groom(0, 0, 1), groom(0, 0, 5)}));
  EXPECT_EQ(both.after, (std::vector<Groom>{groom(0, 0, 3), groom(0, 0, 6)}));
  EXPECT_TRUE(compose(first, inverse(first)).empty());
}

TEST(FieldDelta, DirtyRangesCoverTouchedVerticesAndBridgeSmallGaps) {
  FieldDelta delta;
  delta.vertices = {5, 6, 70, 200};
  const std::vector<VertexRange> ranges = delta.dirty_ranges();
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].begin, 5u);
  EXPECT_EQ(ranges[0].end, 71u);
  EXPECT_EQ(ranges[1].begin, 200u);
  EXPECT_EQ(ranges[1].end, 201u);
}

TEST(FieldDelta, RangesMergeInAnyOrder) {
  const std::vector<VertexRange> merged = merge_ranges({{90, 95}, {0, 10}, {5, 30}, {31, 40}}, 2);
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_EQ(merged[0].begin, 0u);
  EXPECT_EQ(merged[0].end, 40u);
  EXPECT_EQ(merged[1].begin, 90u);
}

TEST(Measure, GivesCountMeanAndLargestOfEachFieldThatChanged) {
  const FieldDelta delta{{0, 1, 2},
                         {groom(0, 0, 1), groom(0.5f, 0, 1), groom(0, 0, 1)},
                         {groom(0.3f, 0.4f, 1), groom(0.5f, 0, 3), groom(0, 1, 2)}};
  const std::vector<FieldChange> changes = measure(delta);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].field, "direction");
  EXPECT_EQ(changes[0].changed, 2u);
  EXPECT_NEAR(changes[0].mean_change, 0.75, 1e-6);
  EXPECT_NEAR(changes[0].max_change, 1, 1e-6);
  EXPECT_EQ(changes[1].field, "length");
  EXPECT_EQ(changes[1].changed, 2u);
  EXPECT_NEAR(changes[1].mean_change, 1.5, 1e-6);
  EXPECT_NEAR(changes[1].max_change, 2, 1e-6);
}

}  // namespace
}  // namespace pelage
