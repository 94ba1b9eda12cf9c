#include "server/fields/edit_layers.h"

#include <gtest/gtest.h>

#include <bit>

#include "server/fields/field_writer.h"

namespace pelage {
namespace {

/// Fields of four vertices with edit layers, changed as a scene would change them.
class Layered {
 public:
  Layered() : fields(4) {
    for (std::uint32_t v = 0; v < 4; ++v) fields.set(v, Groom{{0.1f, -0.2f}, 0.05f, 0});
  }

  void change(EditLayerAction action, const std::string& name, std::optional<double> weight = {},
              std::optional<bool> muted = {}, std::optional<std::string> above = {}) {
    ChangeEditLayer command;
    command.action = action, command.name = name;
    command.weight = weight, command.muted = muted, command.above = above;
    ASSERT_TRUE(check(command, layers).ok());
    apply(change_edit_layers(command, layers, fields));
    layers = with_change(layers, command);
  }
  /// Does what a tool does that wants the resulting value at a vertex: writes the change into an edit layer.
  void want(Field field, std::uint32_t vertex, glm::dvec4 value, const std::string& layer) {
    FieldWriter writer(fields, field);
    writer.put(vertex, value);
    FieldDelta seen;
    writer.finish(seen);
    apply(stored_in_edit_layer(seen, layer, layers, fields));
  }
  float length(std::uint32_t vertex = 0) const { return fields.number(Field::length, vertex); }

  FieldSet fields;
  std::vector<EditLayer> layers;

 private:
  void apply(const FieldDelta& delta) {
    const FieldsHash expected = fields.hash_after(delta), before = fields.hash();
    fields.apply(delta);
    EXPECT_EQ(fields.hash(), expected);
    fields.apply(delta);
    EXPECT_EQ(fields.hash(), before) << "a change of sheets is its own inverse";
    fields.apply(delta);
  }
};

TEST(EditLayers, WhatIsSeenIsTheGroomAndWeightTimesWhatTheLayerAdds) {
  Layered model;
  model.change(EditLayerAction::add, "longer");
  model.want(Field::length, 0, {0.08, 0, 0, 0}, "longer");
  EXPECT_FLOAT_EQ(model.length(), 0.08f);
  for (const auto& [weight, seen] : {std::pair{0.5, 0.065f}, {2.0, 0.11f}, {-1.0, 0.02f}, {0.0, 0.05f}, {-4.0, 0.0f}}) {
    model.change(EditLayerAction::set, "longer", weight);
    EXPECT_NEAR(model.length(), seen, 1e-8) << weight;
    EXPECT_EQ(model.length(1), 0.05f) << "untouched";
  }
}

TEST(EditLayers, AMutedLayerLeavesExactlyTheGroomBelow) {
  Layered model;
  model.change(EditLayerAction::add, "combed");
  const FieldsHash first = model.fields.hash();
  model.want(Field::direction, 2, {-0.5, 0.3, 0, 0}, "combed");
  EXPECT_NE(model.fields.hash(), first);
  model.change(EditLayerAction::set, "combed", {}, true);
  EXPECT_EQ(model.fields.at(2).direction, glm::vec2(0.1f, -0.2f));
  model.change(EditLayerAction::set, "combed", {}, false);
  EXPECT_NEAR(model.fields.at(2).direction.x, -0.5f, 1e-7);
  model.change(EditLayerAction::remove, "combed");
  EXPECT_EQ(model.fields.hash(), first) << "nothing of it is left on any sheet";
}

TEST(EditLayers, AToolIsSeenAtOnceAtAnyWeight) {
  for (const double weight : {1.0, 0.5, 0.05, -0.7, 4.0}) {
    Layered model;
    model.change(EditLayerAction::add, "a", weight);
    model.want(Field::length, 0, {0.09, 0, 0, 0}, "a");
    EXPECT_NEAR(model.length(), 0.09, 1e-8) << weight;
  }
}

TEST(EditLayers, TheGroomIsChangedUnderItsLayers) {
  Layered model;
  model.change(EditLayerAction::add, "longer");
  model.want(Field::length, 0, {0.08, 0, 0, 0}, "longer");
  model.want(Field::length, 0, {0.1, 0, 0, 0}, "");
  EXPECT_NEAR(model.length(), 0.1, 1e-8);
  model.change(EditLayerAction::set, "longer", {}, true);
  EXPECT_NEAR(model.length(), 0.07, 1e-8) << "the groom took the change, the edit layer keeps what it adds";
}

TEST(EditLayers, OrderMattersWhereARangeEnds) {
  Layered model;
  model.change(EditLayerAction::add, "grow");
  model.want(Field::length, 0, {9.95, 0, 0, 0}, "grow");
  model.change(EditLayerAction::set, "grow", 2);
  EXPECT_EQ(model.length(), 10.0f) << "held at the longest fur";
  model.change(EditLayerAction::add, "cut");
  model.want(Field::length, 0, {6, 0, 0, 0}, "cut");
  model.change(EditLayerAction::move, "cut", {}, {}, "");
  EXPECT_EQ(model.layers[0].name, "cut");
  EXPECT_EQ(model.length(), 10.0f) << "0 after the cut, and then grown";
  model.change(EditLayerAction::move, "cut", {}, {}, "grow");
  EXPECT_NEAR(model.length(), 6, 1e-6);
}

TEST(EditLayers, MergingDownKeepsWhatIsSeen) {
  Layered model;
  model.change(EditLayerAction::add, "a", 0.5);
  model.want(Field::length, 0, {0.06, 0, 0, 0}, "a");
  model.change(EditLayerAction::add, "b", -2);
  model.want(Field::length, 0, {0.09, 0, 0, 0}, "b");
  model.want(Field::length, 1, {0.03, 0, 0, 0}, "b");
  model.change(EditLayerAction::merge_down, "b");
  ASSERT_EQ(model.layers.size(), 1u);
  EXPECT_EQ(model.layers[0].weight, 1);
  EXPECT_NEAR(model.length(0), 0.09, 1e-8);
  EXPECT_NEAR(model.length(1), 0.03, 1e-8);
  model.change(EditLayerAction::set, "a", 0.5);
  EXPECT_NEAR(model.length(0), 0.07, 1e-8) << "what both added, halved";
  model.change(EditLayerAction::merge_down, "a");
  EXPECT_TRUE(model.layers.empty());
  EXPECT_NEAR(model.length(0), 0.07, 1e-8);
  EXPECT_TRUE(model.fields.on_sheet(base_sheet, Field::length, 0).x !=
              model.fields.on_sheet(base_sheet, Field::length, 0).x);
}

TEST(EditLayers, WhatIsSeenFollowsFromWhatIsStored) {
  Layered model;
  model.change(EditLayerAction::add, "a", 0.3);
  model.change(EditLayerAction::add, "b", -1.7);
  model.want(Field::direction, 0, {0.7, 0.1, 0, 0}, "a");
  model.want(Field::direction, 0, {-0.33, 0.6, 0, 0}, "b");
  model.want(Field::tip_colour, 0, {0.3, 0.7, 0.9, 0.6}, "a");
  const FieldsHash before = model.fields.hash();
  model.change(EditLayerAction::set, "a", 0.3);
  EXPECT_EQ(model.fields.hash(), before);
  model.change(EditLayerAction::move, "a", {}, {}, "b");
  model.change(EditLayerAction::move, "a", {}, {}, "");
  EXPECT_EQ(model.fields.hash(), before);
}

TEST(EditLayers, PaintThatHalfShowsKeepsItsHue) {
  Layered model;
  model.change(EditLayerAction::add, "spots");
  model.want(Field::tip_colour, 0, {0.8, 0.4, 0.1, 1}, "spots");
  model.change(EditLayerAction::set, "spots", 0.5);
  const glm::vec4 seen = model.fields.value(Field::tip_colour, 0);
  EXPECT_NEAR(seen.w, 0.5, 1e-7);
  EXPECT_NEAR(seen.x, 0.8, 1e-6);
  EXPECT_NEAR(seen.y, 0.4, 1e-6);
  EXPECT_NEAR(seen.z, 0.1, 1e-6);
}

TEST(EditLayers, TheMaskLiesOutsideOfLayers) {
  Layered model;
  model.change(EditLayerAction::add, "a");
  model.want(Field::mask, 0, {0.25, 0, 0, 0}, "a");
  model.change(EditLayerAction::set, "a", {}, true);
  EXPECT_EQ(model.fields.number(Field::mask, 0), 0.25f);
}

TEST(EditLayers, RefusesWhatIsNotThereOrIsTaken) {
  std::vector<EditLayer> layers{{"a", 1, false}, {"b", 1, true}, {"faint", 0.01, false}};
  const auto refused = [&](EditLayerAction action, const char* name, std::optional<std::string> above = {},
                           const char* rename = "") {
    ChangeEditLayer command;
    command.action = action, command.name = name, command.above = above, command.rename = rename;
    return check(command, layers).pointer;
  };
  EXPECT_EQ(refused(EditLayerAction::add, "a"), "/name");
  EXPECT_EQ(refused(EditLayerAction::add, "c", "none"), "/above");
  EXPECT_EQ(refused(EditLayerAction::set, "c"), "/name");
  EXPECT_EQ(refused(EditLayerAction::set, "a", {}, "b"), "/rename");
  EXPECT_EQ(refused(EditLayerAction::set, "a", {}, "a"), "");
  EXPECT_EQ(refused(EditLayerAction::merge_down, "b"), "/name");
  EXPECT_EQ(refused(EditLayerAction::merge_down, "faint"), "/name") << "the one below is muted";
  EXPECT_EQ(check_groomed("b", layers).pointer, "/edit_layer");
  EXPECT_EQ(check_groomed("faint", layers).pointer, "/edit_layer");
  EXPECT_EQ(check_groomed("none", layers).pointer, "/edit_layer");
  EXPECT_TRUE(check_groomed("", layers).ok());
  EXPECT_TRUE(check_groomed("a", layers).ok());
  layers.assign(limits::edit_layers, {"x", 1, false});
  EXPECT_EQ(refused(EditLayerAction::add, "one more"), "/action");
}

}  // namespace
}  // namespace pelage
