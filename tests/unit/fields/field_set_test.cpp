#include "server/fields/field_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "server/fields/field_writer.h"

namespace pelage {
namespace {

Groom groom(float x, float y, float length, float stretch = 0) { return {{x, y}, length, stretch}; }

TEST(FieldSet, HashDependsOnEachBitAndVertexButNotOnTheOrderOfChanges) {
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
  fields.apply(delta);
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

TEST(FieldSet, FieldsTakeNoMemoryBeforeTheyAreTouched) {
  FieldSet fields(100);
  const std::size_t before = fields.bytes();
  EXPECT_EQ(fields.number(Field::density, 3), 1);
  EXPECT_EQ(fields.number(Field::mask, 3), 1);
  EXPECT_EQ(fields.value(Field::tip_colour, 3), glm::vec4(0));
  EXPECT_EQ(fields.bytes(), before);
  EXPECT_TRUE(fields.at_default(Field::tip_colour));
  const FieldsHash default_hash = fields.hash();
  fields.set(Field::tip_colour, 3, {0.1f, 0.2f, 0.3f, 1});
  EXPECT_EQ(fields.bytes(), before + 1600);
  EXPECT_NE(fields.hash(), default_hash);
  fields.set(Field::tip_colour, 3, glm::vec4(0));
  EXPECT_EQ(fields.hash(), default_hash) << "a field at its default again adds nothing";
}

TEST(FieldSet, WhatIsTakenBackTakesNoMemoryAgain) {
  FieldSet fields(100), painted(100);
  painted.set(Field::density, 7, glm::vec4(0.5f));
  painted.set(Field::root_colour, 99, glm::vec4(0.5f));
  painted.set(Field::length, 3, glm::vec4(0.5f));
  const std::size_t bytes = fields.bytes();
  const FieldDelta delta = difference(fields, painted);
  fields.apply(delta);
  EXPECT_FALSE(fields.at_default(Field::density));
  EXPECT_GT(fields.bytes(), bytes);
  FieldDelta half = delta;
  half.parts.resize(1);  // the array of a field that always exists stays
  fields.apply(half);
  EXPECT_GT(fields.bytes(), bytes);
  fields.apply(half), fields.apply(delta);
  EXPECT_TRUE(fields.at_default(Field::density) && fields.at_default(Field::root_colour));
  EXPECT_EQ(fields.bytes(), bytes);
  EXPECT_EQ(fields.length().size(), 100u);
  EXPECT_EQ(fields.hash(), FieldSet(100).hash());
}

TEST(FieldSet, EveryChannelOfEveryFieldIsInTheHash) {
  std::vector<FieldsHash> seen{FieldSet(2).hash()};
  for (std::size_t f = 0; f < field_count; ++f) {
    for (int c = 0; c < shape_of(field_at(f)).channels; ++c) {
      FieldSet fields(2);
      glm::vec4 value = fields.value(field_at(f), 1);
      value[c] = 0.5f;
      fields.set(field_at(f), 1, value);
      EXPECT_EQ(std::count(seen.begin(), seen.end(), fields.hash()), 0) << shape_of(field_at(f)).name << c;
      seen.push_back(fields.hash());
    }
  }
}

TEST(FieldSet, RefusesVerticesThatItDoesNotHave) {
  const FieldDelta delta{{{Field::length, {1, 3}, {1, 1}}}};
  EXPECT_TRUE(FieldSet(4).accepts(delta));
  EXPECT_FALSE(FieldSet(3).accepts(delta));
}

/// The delta between two field sets with these lengths at the given vertices.
FieldDelta lengths(std::vector<std::pair<std::uint32_t, float>> before,
                   std::vector<std::pair<std::uint32_t, float>> after) {
  FieldSet from(300), to(300);
  for (const auto& [v, length] : before) from.set(Field::length, v, {length, 0, 0, 0});
  for (const auto& [v, length] : after) to.set(Field::length, v, {length, 0, 0, 0});
  return difference(from, to);
}

TEST(FieldDelta, ComposeKeepsEndsAndDropsReturns) {
  const FieldDelta first = lengths({{1, 1}, {4, 2}, {6, 5}}, {{1, 3}, {4, 4}, {6, 5}});
  const FieldDelta second = lengths({{1, 3}, {4, 4}, {6, 5}}, {{1, 3}, {4, 2}, {6, 6}});
  const FieldDelta both = compose(first, second);
  EXPECT_EQ(both, lengths({{1, 1}, {6, 5}}, {{1, 3}, {6, 6}}));
  EXPECT_EQ(both.vertices(), (std::vector<std::uint32_t>{1, 6}));
  EXPECT_TRUE(compose(first, first).empty()) << "a change is its own inverse";
}

TEST(FieldDelta, KeepsFieldsApart) {
  FieldSet from(10), to(10);
  to.set(Field::mask, 2, {0.5f, 0, 0, 0});
  to.set(Field::root_colour, 1, {0, 0.5f, 0, 1});
  to.set(Field::root_colour, 2, {0, 0.5f, 0, 1});
  const FieldDelta delta = difference(from, to);
  ASSERT_EQ(delta.parts.size(), 2u);
  EXPECT_EQ(delta.part(Field::mask)->vertices.size(), 1u);
  EXPECT_EQ(delta.part(Field::root_colour)->flips.size(), 8u);
  EXPECT_EQ(delta.part(Field::length), nullptr);
  EXPECT_EQ(delta.vertices(), (std::vector<std::uint32_t>{1, 2}));
  from.apply(delta);
  EXPECT_EQ(from.value(Field::root_colour, 1), glm::vec4(0, 0.5f, 0, 1));
  EXPECT_EQ(from.hash(), to.hash());
}

TEST(FieldDelta, ACombedVertexTakesTwelveBytes) {
  FieldSet from(10), to(10);
  to.set(Field::direction, 2, {0.5f, 0.1f, 0, 0});
  EXPECT_EQ(difference(from, to).bytes(), 12u);
}

TEST(FieldDelta, DirtyRangesAreTheTouchedVertices) {
  const FieldDelta delta{{{Field::length, {5, 7}, {1, 1}}, {Field::mask, {6, 200}, {1, 1}}}};
  const std::vector<VertexRange> ranges = delta.dirty_ranges();
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].begin, 5u);
  EXPECT_EQ(ranges[0].end, 8u);
  EXPECT_EQ(ranges[1].begin, 200u);
  EXPECT_EQ(ranges[1].end, 201u);
}

TEST(FieldDelta, RangesMergeInAnyOrder) {
  const std::vector<VertexRange> merged = merge_ranges({{90, 95}, {0, 10}, {5, 30}, {30, 40}});
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_EQ(merged[0].begin, 0u);
  EXPECT_EQ(merged[0].end, 40u);
  EXPECT_EQ(merged[1].begin, 90u);
}

TEST(Measure, GivesCountMeanAndLargestOfEachFieldThatChanged) {
  FieldSet from(3), to(3);
  from.set(0, groom(0, 0, 1)), from.set(1, groom(0.5f, 0, 1)), from.set(2, groom(0, 0, 1));
  to.set(0, groom(0.3f, 0.4f, 1)), to.set(1, groom(0.5f, 0, 3)), to.set(2, groom(0, 1, 2));
  const FieldDelta delta = difference(from, to);
  for (const FieldSet* fields : {&from, &to}) {
    const std::vector<FieldChange> changes = measure(delta, *fields);
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
}

TEST(FieldWriter, KeepsOnlyWhatChangesAndHoldsValuesInRange) {
  FieldSet fields(5);
  FieldWriter width(fields, Field::width), direction(fields, Field::direction);
  EXPECT_FALSE(width.put(0, 1.0));
  EXPECT_TRUE(width.put(1, 9.0));
  EXPECT_TRUE(width.put(3, -1.0));
  EXPECT_FALSE(direction.put(2, glm::dvec2(3, 4)));
  FieldDelta delta;
  direction.finish(delta), width.finish(delta);
  fields.apply(delta);
  EXPECT_EQ(delta.part(Field::width)->vertices, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(fields.number(Field::width, 1), 4);
  EXPECT_EQ(fields.number(Field::width, 3), 0);
  EXPECT_NEAR(fields.at(2).direction.x, 0.6, 1e-6);
}

}  // namespace
}  // namespace pelage
