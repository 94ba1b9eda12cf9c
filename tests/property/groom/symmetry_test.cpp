// Images of commands under a symmetry, and inverted tools.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "tests/property/groom/command_maker.h"
#include "tests/property/groom/models.h"
#include "tests/property/groom/reference/groomed.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_commands::CommandMaker;
using testing_commands::Numbers;
using testing_commands::Views;
using testing_shapes::lean_of;
using testing_shapes::stroke_through;

/// Collects every position and direction of a command, for comparison.
std::vector<glm::dvec3> positions_of(const Command& command) {
  std::vector<glm::dvec3> positions;
  std::visit(
      [&](const auto& tool) {
        if constexpr (requires { tool.stroke->samples; }) {
          if (tool.stroke) {
            for (const StrokeSample& sample : tool.stroke->samples)
              positions.push_back(std::get<PositionSample>(sample.position).position);
          }
        }
        if constexpr (requires { tool.source; }) positions.push_back(tool.source), positions.push_back(tool.direction);
        if constexpr (requires { tool.point; }) positions.push_back(tool.point);
        if constexpr (requires { tool.turn_degrees; }) positions.push_back(glm::dvec3(tool.turn_degrees));
        if constexpr (std::is_same_v<std::decay_t<decltype(tool)>, Unify>)
          positions.push_back(tool.direction.value_or(glm::dvec3(0)));
        if constexpr (std::is_same_v<std::decay_t<decltype(tool)>, Trim>) {
          if (auto* plane = std::get_if<TrimPlane>(&tool.shape))
            positions.push_back(plane->point), positions.push_back(plane->normal);
          if (auto* sphere = std::get_if<TrimSphere>(&tool.shape)) positions.push_back(sphere->centre);
        }
        if constexpr (requires { tool.keys; }) {
          for (const Key& key : tool.keys)
            positions.push_back(key.position), positions.push_back(key.direction.value_or(glm::dvec3(0)));
        }
        if constexpr (requires { tool.curves; }) {
          for (const auto& curve : tool.curves) positions.insert(positions.end(), curve.begin(), curve.end());
        }
      },
      command);
  return positions;
}

bool is_flood(const Command& command) {
  return std::visit(
      [](const auto& tool) {
        if constexpr (requires { tool.flood; }) return tool.flood;
        return false;
      },
      command);
}

bool on_positions(const Command& command) {
  const Stroke* stroke = stroke_of(command);
  return stroke == nullptr ||
         std::all_of(stroke->samples.begin(), stroke->samples.end(), [](const StrokeSample& sample) {
           return std::holds_alternative<PositionSample>(sample.position);
         });
}

Symmetry random_symmetry(Random& random) {
  const auto vector = [&](double reach) {
    return glm::dvec3(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
  };
  Symmetry symmetry;
  for (int k = static_cast<int>(random.uniform(0, 3)); k > 0; --k) symmetry.planes.push_back({vector(0.1), vector(1)});
  symmetry.axis_point = vector(0.1), symmetry.axis = vector(1);
  symmetry.count = static_cast<int>(random.uniform(1, 5));
  return symmetry;
}

RC_GTEST_PROP(Symmetry, ImagesAreThoseOfTheSecondImplementation, (std::uint64_t seed)) {
  Random random(seed);
  const Surface surface = testing_models::surface_of(testing_models::dented_builtin(random));
  CommandMaker make(seed, surface, Numbers::ordinary, Views::none);
  constexpr std::size_t last_with_positions = 15;  // the mask selects positions and is no stroke
  Command command = make.command(static_cast<std::size_t>(random.uniform(0, last_with_positions + 1)));
  if (is_flood(command) || !on_positions(command)) return;
  const Symmetry symmetry = random_symmetry(random);
  const bool own = random.uniform(0, 1) < 0.5;  // the brush's symmetry instead of the scene's
  brush_of(command)->symmetry = own ? std::optional(symmetry) : std::nullopt;
  std::vector<glm::dvec3> expected, found;
  for (const Command& image : plain::images(command, symmetry)) {
    for (const glm::dvec3 position : positions_of(image)) expected.push_back(position);
  }
  for (const Command& image : symmetry_images(command, own ? random_symmetry(random) : symmetry, surface)) {
    for (const glm::dvec3 position : positions_of(image)) found.push_back(position);
  }
  RC_ASSERT(expected.size() == found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    RC_ASSERT(glm::distance(expected[k], found[k]) < 1e-9 * (1 + glm::length(found[k])));
}

// Two small strokes that do not overlap: the symmetry does what both do.
TEST(Symmetry, TouchesTheUnionOfTheStrokeAndItsImage) {
  const Surface sphere = testing_shapes::make_surface(Builtin::sphere, 2000);
  const FieldSet fields = first_groom(sphere.mesh(), {});
  Comb comb;
  comb.stroke = stroke_through(sphere, {{0.2, 0, 0.2}, {0.2, 0.05, 0.2}});
  comb.brush.radius = 0.08;
  Symmetry symmetry;
  symmetry.planes = {Plane{sphere.mesh().to_model(glm::dvec3(0)), {1, 0, 0}}};
  const std::vector<Command> images = symmetry_images(comb, symmetry, sphere);
  ASSERT_EQ(images.size(), 2u);
  const FieldDelta first = evaluate(images[0], sphere, fields).delta,
                   second = evaluate(images[1], sphere, fields).delta;
  ASSERT_FALSE(first.empty());
  FieldSet between = fields;
  between.apply(first);
  const FieldDelta both = compose(first, evaluate(images[1], sphere, between).delta);
  EXPECT_EQ(both, compose(first, second));
  EXPECT_EQ(both.vertices().size(), first.vertices().size() + second.vertices().size());
}

/// What a tool and its inverse make of the same fur.
std::pair<FieldSet, FieldSet> opposites(const Surface& surface, Command command, const FieldSet& before) {
  FieldSet there = before, back = before;
  there.apply(evaluate(command, surface, before).delta);
  std::visit(
      [](auto& tool) {
        if constexpr (requires { tool.brush; }) tool.brush.invert = !tool.brush.invert;
      },
      command);
  back.apply(evaluate(command, surface, before).delta);
  return {there, back};
}

class Opposites : public ::testing::Test {
 protected:
  Command reversed(Command command) const {
    std::visit(
        [](auto& tool) {
          if constexpr (requires { tool.brush; }) tool.brush.invert = true;
        },
        command);
    return command;
  }
  FieldSet after(const Command& command, const FieldSet& before) const {
    FieldSet fields = before;
    fields.apply(evaluate(command, sphere_, before).delta);
    return fields;
  }

  Surface sphere_ = testing_shapes::make_surface(Builtin::sphere, 1000);
  FieldSet upright_ = first_groom(sphere_.mesh(), {.length = 0.1, .inclination = 0});
};

TEST_F(Opposites, CombWindPartingAndNoiseLeanInTheOppositeDirection) {
  Comb comb;
  comb.stroke = stroke_through(sphere_, {{0.2, 0, 0.2}, {0, 0.1, 0.25}});
  comb.brush.radius = 0.2;
  Blow blow;
  blow.source = sphere_.mesh().to_model({0, 0.5, 0.5});
  Part part;
  part.stroke = comb.stroke, part.brush = comb.brush;
  Noise noise;
  noise.flood = true;
  for (const Command& command : {Command(comb), Command(blow), Command(part), Command(noise)}) {
    const auto [there, back] = opposites(sphere_, command, upright_);
    ASSERT_NE(there.hash(), upright_.hash()) << op_of(command);
    for (std::uint32_t v = 0; v < there.size(); ++v)
      ASSERT_LT(glm::distance(there.at(v).direction, -back.at(v).direction), 1e-6f) << op_of(command);
  }
}

TEST_F(Opposites, AddingScalingAndTurningAreTakenBack) {
  const FieldSet leaning = first_groom(sphere_.mesh(), {.length = 0.1, .inclination = 0.5});
  Length add, scale;
  add.flood = scale.flood = true;
  add.brush.strength = scale.brush.strength = 1;
  add.mode = LengthMode::add, add.value = 0.05;
  scale.mode = LengthMode::scale, scale.value = 3;
  Curl curl;
  curl.flood = true, curl.turn_degrees = 70, curl.amount = 0;
  for (const Command& command : {Command(add), Command(scale), Command(curl)}) {
    const FieldSet there = after(command, leaning), back = after(reversed(command), there);
    ASSERT_NE(there.hash(), leaning.hash());
    for (std::uint32_t v = 0; v < back.size(); ++v) {
      ASSERT_NEAR(back.at(v).length, leaning.at(v).length, 1e-7) << op_of(command);
      ASSERT_LT(glm::distance(back.at(v).direction, leaning.at(v).direction), 1e-6f) << op_of(command);
    }
  }
}

TEST_F(Opposites, ThePaintedMaskInvertedTwiceIsItself) {
  Paint paint;
  paint.field = Field::mask, paint.value = 0.25;
  paint.stroke = stroke_through(sphere_, {{0, 0, 0.3}});
  paint.brush.radius = 0.3;
  ChangeMask invert;
  invert.action = MaskAction::invert;
  const FieldSet painted = after(paint, upright_);
  ASSERT_NE(painted.hash(), upright_.hash());
  const FieldSet twice = after(invert, after(invert, painted));
  for (std::uint32_t v = 0; v < twice.size(); ++v)
    ASSERT_NEAR(twice.number(Field::mask, v), painted.number(Field::mask, v), 1e-7);
}

}  // namespace
}  // namespace pelage
