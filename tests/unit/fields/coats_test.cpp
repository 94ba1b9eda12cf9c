// How coats share, get and lose fields; their hashes and deltas.
#include "server/fields/coats.h"

#include <gtest/gtest.h>

#include "base/limits.h"
#include "server/fields/edit_layers.h"

namespace pelage::coats_test {
namespace {

constexpr std::uint32_t vertices = 5;

/// Fur whose length and mask rise from vertex to vertex.
FieldSet groomed() {
  FieldSet fields(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    fields.set(Field::length, v, {0.01f * static_cast<float>(v + 1), 0, 0, 0});
    fields.set(Field::direction, v, {0.5f, 0.1f * static_cast<float>(v), 0, 0});
    fields.set(Field::mask, v, {0.25f * static_cast<float>(v), 0, 0, 0});
  }
  return fields;
}

SetCoats with_mane(CoatRegion region, double length = 2) {
  return {{{.name = "fur"}, {.name = "mane", .begins = CoatBeginning{.region = region, .length = length}}}};
}

const std::vector<NamedCoat> one{1};

TEST(Coats, ACopySharesNothingThatIsChanged) {
  const FieldSet before = groomed();
  FieldSet after = before;
  after.set(Field::length, 2, {0.5f, 0, 0, 0});
  EXPECT_EQ(before.number(Field::length, 2), 0.03f);
  EXPECT_EQ(after.number(Field::length, 2), 0.5f);
  EXPECT_EQ(before.hash(), groomed().hash());
}

TEST(Coats, EachHasItsOwnFieldsButForThoseThatAllShare) {
  FieldSet fields = groomed();
  const FieldsHash alone = fields.hash();
  FieldSet mane = fields.of_coat(3);
  EXPECT_EQ(mane.hash(), alone) << "a coat at its defaults adds nothing";
  EXPECT_EQ(mane.number(Field::length, 1), 0);
  EXPECT_EQ(mane.direction().size(), vertices);
  EXPECT_EQ(mane.number(Field::mask, 1), 0.25f);
  mane.set(Field::length, 1, {0.7f, 0, 0, 0}), mane.set(Field::mask, 1, {1, 0, 0, 0});
  mane.select(0);
  EXPECT_EQ(mane.number(Field::length, 1), 0.02f);
  EXPECT_EQ(mane.number(Field::mask, 1), 1) << "shared";
  EXPECT_NE(mane.hash(), alone);
  FieldSet one = fields.of_coat(1), two = fields.of_coat(2);
  one.set(Field::length, 1, {0.7f, 0, 0, 0}), two.set(Field::length, 1, {0.7f, 0, 0, 0});
  EXPECT_NE(one.hash(), two.hash()) << "the same in another coat";
}

TEST(Coats, ADeltaLeadsThereAndBackWhicheverCoatIsSelected) {
  const FieldSet before = groomed();
  FieldSet after = before.of_coat(2);
  after.set(Field::length, 3, {0.1f, 0, 0, 0}), after.set(Field::bare, 4, {1, 0, 0, 0});
  const FieldDelta delta = difference(before, after);
  ASSERT_NE(delta.part(Field::length, visible_sheet, 2), nullptr);
  EXPECT_NE(delta.part(Field::bare), nullptr) << "what is shared belongs to no coat";
  FieldSet there = before;
  EXPECT_EQ(there.hash_after(delta), after.hash());
  there.apply(delta);
  EXPECT_EQ(there.hash(), after.hash());
  there.apply(delta);
  EXPECT_EQ(there.hash(), before.hash());
  EXPECT_TRUE(difference(there, before).empty());
}

TEST(Coats, ANewOneBeginsAsAnotherIsSeenInItsRegion) {
  FieldSet fields = groomed();
  for (const auto& [region, density] :
       {std::pair{CoatRegion::all, 1.0f}, {CoatRegion::none, 0.0f}, {CoatRegion::mask, 0.75f}}) {
    const SetCoats command = with_mane(region);
    ASSERT_TRUE(check(command, one).ok());
    FieldSet after = fields;
    after.apply(change_coats(command, one, fields));
    const FieldSet mane = after.of_coat(with_change(one, command)[1].id);
    EXPECT_EQ(mane.number(Field::length, 3), 0.08f);
    EXPECT_EQ(mane.value(Field::direction, 3), fields.value(Field::direction, 3));
    EXPECT_EQ(mane.number(Field::density, 3), density);
    EXPECT_EQ(after.number(Field::density, 3), 1) << "the first one stays";
  }
}

TEST(Coats, ThatAreRemovedLeaveNothingAndTheirNumberIsFreeForTheNextCommand) {
  const FieldSet fields = groomed();
  const SetCoats add = with_mane(CoatRegion::all);
  const std::vector<NamedCoat> two = with_change(one, add);
  FieldSet both = fields;
  both.apply(change_coats(add, one, fields));
  const SetCoats remove{{{.name = "fur"}}}, replace{{{.name = "fur"}, {.name = "tail"}}};
  FieldSet after = both;
  after.apply(change_coats(remove, two, both));
  EXPECT_EQ(after.hash(), fields.hash());
  EXPECT_EQ(with_change(two, replace)[1].id, 2u) << "that of the mane is taken until it has gone";
  EXPECT_EQ(with_change(with_change(two, remove), replace)[1].id, 1u);
  FieldSet replaced = both;
  replaced.apply(change_coats(replace, two, both));
  EXPECT_EQ(replaced.of_coat(1).number(Field::length, 2), 0);
  EXPECT_EQ(replaced.of_coat(2).number(Field::length, 2), 0.03f);
}

TEST(Coats, AreNamedByTheirIdOrTheirName) {
  const std::vector<NamedCoat> two = with_change(one, with_mane(CoatRegion::all));
  const std::vector<NamedCoat> renamed =
      with_change(two, {{{.name = "ruff", .id = 1, .muted = true}, {.name = "fur", .coat = Coat{.count = 7}}}});
  ASSERT_EQ(renamed.size(), 2u);
  EXPECT_EQ(renamed[0], (NamedCoat{"ruff", 1, true, two[1].coat}));
  EXPECT_EQ(renamed[1], (NamedCoat{"fur", 0, false, Coat{.count = 7}}));
  const auto refused = [&](const SetCoats& command) { return check(command, two).pointer; };
  EXPECT_EQ(refused({{{.name = "fur"}, {.name = "hair", .id = 0}}}), "/coats") << "both are the first one";
  EXPECT_EQ(refused({{{.name = "mane", .begins = CoatBeginning{}}}}), "/coats/0/begins");
  EXPECT_EQ(refused({{{.name = "fur"}, {.name = "tail", .begins = CoatBeginning{.from = "beard"}}}}),
            "/coats/1/begins/from");
  SetCoats many{{{.name = "fur"}}};
  for (std::size_t k = 1; k < limits::coats; ++k) many.coats.push_back({.name = std::to_string(k)});
  EXPECT_EQ(refused(many), "/coats") << "the mane, which goes, still has a number";
  EXPECT_TRUE(check(many, one).ok());
}

TEST(Coats, ToolsWorkOnThoseThatAreNamedOrSeen) {
  std::vector<NamedCoat> coats = with_change(one, with_mane(CoatRegion::all));
  coats.push_back({"tail", 5, true, {}});
  const std::vector<EditLayer> layers{{.name = "all"}, {.name = "swept", .coat = "mane"}};
  EXPECT_EQ(coats_to_groom({}, "", coats, layers), (std::vector<CoatId>{0, 1}));
  EXPECT_EQ(coats_to_groom({"mane"}, "all", coats, layers), (std::vector<CoatId>{1}));
  EXPECT_EQ(coats_to_groom({}, "swept", coats, layers), (std::vector<CoatId>{1}));
  EXPECT_TRUE(check_groomed_coats({"fur", "mane"}, "", coats, layers).ok());
  EXPECT_EQ(check_groomed_coats({"fur", "beard"}, "", coats, layers).pointer, "/coats/1");
  EXPECT_EQ(check_groomed_coats({"tail"}, "", coats, layers).pointer, "/coats/0") << "muted";
  EXPECT_EQ(check_groomed_coats({"fur"}, "swept", coats, layers).pointer, "/coats/0") << "of another coat";
}

TEST(Coats, EditLayersFollowTheNameOfTheirCoat) {
  const std::vector<NamedCoat> two = with_change(one, with_mane(CoatRegion::all));
  const std::vector<NamedCoat> renamed = with_change(two, {{{.name = "fur"}, {.name = "ruff", .id = 1}}});
  EXPECT_EQ(with_coats({{.name = "swept", .coat = "mane"}}, two, renamed)[0].coat, "ruff");
  EXPECT_EQ(with_coats({{.name = "swept", .coat = "mane"}}, two, one)[0].coat, "") << "it went";
  EXPECT_EQ(with_coats({{.name = "swept"}}, two, renamed)[0].coat, "");
}

TEST(Coats, EditLayersStoreWhatChangesInEachCoat) {
  const std::vector<EditLayer> layers{{.name = "swept"}};
  FieldSet fields = groomed();
  fields.apply(change_coats(with_mane(CoatRegion::all), one, fields));
  const FieldsHash before = fields.hash();
  FieldSet mane = fields.of_coat(1);
  FieldDelta change{{{Field::length, {2}, {}, visible_sheet, 1}}};
  change.parts[0].flips = {std::bit_cast<std::uint32_t>(mane.number(Field::length, 2)) ^
                           std::bit_cast<std::uint32_t>(0.5f)};
  fields.apply(stored_in_edit_layer(change, "swept", layers, mane));
  EXPECT_EQ(fields.of_coat(1).number(Field::length, 2), 0.5f);
  EXPECT_EQ(fields.number(Field::length, 2), 0.03f);
  const ChangeEditLayer remove{.action = EditLayerAction::remove, .name = "swept"};
  fields.apply(change_edit_layers(remove, layers, fields));
  EXPECT_EQ(fields.hash(), before);
}

}  // namespace
}  // namespace pelage::coats_test
