#include <cmath>
#include <numbers>

#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;
using testing_shapes::vertex_towards;

class ToolsTest : public ::testing::Test {
 protected:
  FieldSet after(const Command& command, const FieldSet& before) const {
    FieldSet fields = before;
    fields.apply(evaluate(command, sphere_, before).delta);
    return fields;
  }
  FieldSet after(const Command& command) const { return after(command, upright_); }
  glm::dvec3 lean(const FieldSet& fields, std::uint32_t v) const { return lean_of(sphere_, fields.at(v), v); }
  glm::dvec3 position(std::uint32_t v) const { return glm::dvec3(sphere_.mesh().positions[v]); }
  glm::dvec3 to_model(glm::dvec3 internal) const { return sphere_.mesh().to_model(internal); }

  Surface sphere_ = make_surface(Builtin::sphere, 4000);
  FieldSet upright_ = first_groom(sphere_.mesh(), {.length = 0.03, .inclination = 0});
  std::uint32_t front_ = vertex_towards(sphere_, {0, 0, 1});
};

TEST_F(ToolsTest, CombTurnsFurTheWayTheStrokeMovesByTheFormula) {
  const glm::dvec3 p = position(front_);
  Comb comb;
  comb.stroke = stroke_through(sphere_, {p - glm::dvec3(0, 0.02, 0), p});
  comb.brush = {.radius = 0.04, .falloff = Falloff::constant, .strength = 0.6, .spacing = 0.5};
  const glm::dvec3 combed = lean(after(comb), front_);
  const double weight = 1 - std::pow(1 - 0.6, 0.5);
  EXPECT_NEAR(glm::length(combed), 0.7 * weight, 1e-6);
  EXPECT_GT(glm::dot(glm::normalize(combed), glm::dvec3(0, 1, 0)), 0.99);
  comb.brush.invert = true;
  EXPECT_NEAR(glm::distance(lean(after(comb), front_), -combed), 0, 1e-6);
}

TEST_F(ToolsTest, CombsEffectFollowsArcLengthAndNotSpacing) {
  const glm::dvec3 p = position(front_);
  Comb comb;
  comb.stroke = stroke_through(sphere_, {p - glm::dvec3(0.1, 0, 0), p + glm::dvec3(0.1, 0, 0)});
  comb.brush = {.radius = 0.5, .falloff = Falloff::constant, .strength = 0.5, .spacing = 0.4};
  const glm::dvec3 coarse = lean(after(comb), front_);
  comb.brush.spacing = 0.02;
  EXPECT_NEAR(glm::distance(lean(after(comb), front_), coarse), 0, 1e-6);
}

TEST_F(ToolsTest, CombLeavesWhatTheBrushDoesNotReach) {
  const glm::dvec3 p = position(front_);
  Comb comb;
  comb.stroke = stroke_through(sphere_, {p, p + glm::dvec3(0, 0.05, 0)});
  comb.brush.radius = 0.05;
  const Evaluation done = evaluate(comb, sphere_, upright_);
  ASSERT_FALSE(done.delta.empty());
  for (const std::uint32_t v : done.delta.vertices()) EXPECT_LT(glm::distance(position(v), p), 0.1 + 1e-9);
  EXPECT_EQ(done.delta.part(Field::length), nullptr);
}

TEST_F(ToolsTest, FloodCombsEverythingItsDirection) {
  Comb comb;
  comb.flood = true;
  comb.direction = glm::dvec3(0, -1e200, 0);
  comb.brush.strength = 1;
  const FieldSet combed = after(comb);
  for (std::uint32_t v = 0; v < combed.size(); ++v) {
    if (std::abs(sphere_.mesh().normals[v].y) > 0.99f) continue;
    EXPECT_NEAR(glm::length(lean(combed, v)), 0.7, 1e-5);
    EXPECT_LT(lean(combed, v).y, 0);
  }
}

TEST_F(ToolsTest, WindBlowsAwayFromItsSourceInsideTheCone) {
  Blow blow;
  blow.source = to_model({0, 0.6, 0.6});
  blow.direction = {0, -0.6, -0.4};
  blow.cone_degrees = 20;
  blow.strength = 1;
  const Evaluation done = evaluate(blow, sphere_, upright_);
  ASSERT_FALSE(done.delta.empty());
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0, -0.6, -0.4)), source(0, 0.6, 0.6);
  std::size_t inside = 0;
  for (std::uint32_t v = 0; v < upright_.size(); ++v) {
    inside += std::acos(glm::dot(glm::normalize(position(v) - source), axis)) < 20 * std::numbers::pi / 180;
  }
  EXPECT_EQ(done.delta.vertices().size(), inside);
  FieldSet blown = upright_;
  blown.apply(done.delta);
  double strongest = 0;
  for (const std::uint32_t v : done.delta.vertices()) {
    EXPECT_GE(glm::dot(lean(blown, v), position(v) - source), 0);
    strongest = std::max(strongest, glm::length(lean(blown, v)));
  }
  EXPECT_NEAR(strongest, 0.7, 1e-5);
}

TEST_F(ToolsTest, WindFadesOverTheSoftEdgeAndTurnsWhenInverted) {
  Blow blow;
  blow.source = to_model({0, 0.1, 2});
  blow.direction = {0, -0.1, -2};
  blow.cone_degrees = 6;
  blow.strength = 1;
  blow.softness = 1;
  const FieldSet soft = after(blow);
  blow.softness = 0;
  const FieldSet hard = after(blow);
  blow.brush.invert = true;
  const FieldSet inverted = after(blow);
  std::size_t softer = 0;
  for (std::uint32_t v = 0; v < upright_.size(); ++v) {
    const double hard_lean = glm::length(lean(hard, v));
    EXPECT_TRUE(hard_lean == 0 || std::abs(hard_lean - 0.7) < 1e-5);
    EXPECT_LE(glm::length(lean(soft, v)), hard_lean + 1e-6);
    softer += hard_lean > 0 && glm::length(lean(soft, v)) < 0.35;
    EXPECT_NEAR(glm::distance(lean(inverted, v), -lean(hard, v)), 0, 1e-5);
  }
  EXPECT_GT(softer, 10u);
}

TEST_F(ToolsTest, AStrokeRestrictsTheWind) {
  Blow blow;
  blow.source = to_model({0, 1, 2});
  blow.direction = {0, -1, -2};
  blow.strength = 1;
  blow.stroke = stroke_through(sphere_, {position(front_)});
  blow.brush = {.radius = 0.08, .strength = 1};
  const Evaluation done = evaluate(blow, sphere_, upright_);
  ASSERT_FALSE(done.delta.empty());
  for (const std::uint32_t v : done.delta.vertices()) EXPECT_LT(glm::distance(position(v), position(front_)), 0.08);
}

TEST_F(ToolsTest, AttractTurnsTipsToThePoint) {
  const glm::dvec3 point(0, 0.1, 0.35);
  Attract attract;
  attract.point = to_model(point);
  attract.radius = 0.5;
  attract.strength = 1;
  attract.brush.falloff = Falloff::constant;
  const FieldSet pulled = after(attract);
  const glm::dvec3 to_point = glm::normalize(point - position(front_));
  const glm::dvec3 leaning = lean(pulled, front_);
  const double angle = glm::length(leaning) * std::numbers::pi / 2;
  const glm::dvec3 normal(sphere_.mesh().normals[front_]);
  const glm::dvec3 tip = std::cos(angle) * normal + std::sin(angle) * glm::normalize(leaning);
  EXPECT_GT(glm::dot(tip, to_point), 0.9999);
  attract.brush.invert = true;
  EXPECT_LT(glm::dot(lean(after(attract), front_), to_point), -0.1);
}

TEST_F(ToolsTest, AttractStretchesByTheFormulaAndAddsUp) {
  const glm::dvec3 normal(sphere_.mesh().normals[front_]);
  Attract attract;
  attract.point = to_model(position(front_) + 0.1 * normal);
  attract.radius = 0.2;
  attract.strength = 0.5;
  attract.duration = 2;
  attract.threshold = 0.25;
  attract.brush.falloff = Falloff::linear;
  const double added = 0.5 * 0.5 * 2;  // strength, falloff halfway, duration; the pull is along the upright strand
  const FieldSet once = after(attract);
  EXPECT_NEAR(once.at(front_).stretch, added, 1e-3);
  EXPECT_NEAR(once.at(front_).length, 0.03 * (1 + added - 0.25), 1e-4);
  const FieldSet twice = after(attract, once);
  EXPECT_NEAR(twice.at(front_).stretch, 2 * added, 2e-3);
  EXPECT_NEAR(twice.at(front_).length, 0.03 * (1 + 2 * added - 0.25), 1e-4);
}

TEST_F(ToolsTest, ShortPullsUnderTheThresholdKeepTheLength) {
  Attract attract;
  attract.point = to_model(position(front_) + glm::dvec3(0, 0, 0.05));
  attract.strength = 0.2;
  attract.threshold = 0.3;
  const FieldSet pulled = after(attract);
  EXPECT_GT(pulled.at(front_).stretch, 0.05);
  EXPECT_EQ(pulled.at(front_).length, upright_.at(front_).length);
}

TEST_F(ToolsTest, LengthIsHeldAtMaxStretchAndCounted) {
  Attract attract;
  attract.point = to_model(position(front_) + glm::dvec3(0, 0, 0.1));
  attract.radius = 0.3;
  attract.strength = 1;
  attract.duration = 100;
  attract.max_stretch = 3;
  Evaluation done = evaluate(attract, sphere_, upright_);
  EXPECT_GT(done.clamped, 20u);
  FieldSet fields = upright_;
  for (int again = 0; again < 4; ++again) {
    fields.apply(evaluate(attract, sphere_, fields).delta);
    for (std::uint32_t v = 0; v < fields.size(); ++v) ASSERT_LE(fields.at(v).length, 0.03 * 3 * (1 + 1e-5));
  }
  EXPECT_NEAR(fields.at(front_).length, 0.09, 1e-5);
}

TEST_F(ToolsTest, ZeroStrengthGivesAnEmptyDelta) {
  const FieldSet furry = first_groom(sphere_.mesh(), {});
  Comb comb;
  comb.stroke = stroke_through(sphere_, {{0, 0, 0.3}, {0, 0.1, 0.3}});
  comb.brush = {.radius = 1, .strength = 0};
  Comb flood;
  flood.flood = true;
  flood.direction = glm::dvec3(1, 0, 0);
  flood.brush.strength = 0;
  Blow blow;
  blow.source = to_model({0, 0, 1});
  blow.direction = {0, 0, -1};
  blow.strength = 0;
  Attract attract;
  attract.radius = 3;
  attract.strength = 0;
  for (const Command& command : {Command(comb), Command(flood), Command(blow), Command(attract)}) {
    EXPECT_TRUE(evaluate(command, sphere_, furry).delta.empty()) << op_of(command);
  }
}

TEST_F(ToolsTest, SettingsChangeNoField) {
  EXPECT_TRUE(evaluate(SetCoat{}, sphere_, upright_).delta.empty());
  EXPECT_TRUE(evaluate(SetLights{}, sphere_, upright_).delta.empty());
}

}  // namespace
}  // namespace pelage
