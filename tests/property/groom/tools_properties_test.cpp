#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/random.h"
#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "tests/property/groom/command_maker.h"
#include "tests/property/groom/models.h"
#include "tests/property/groom/reference/brush.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_commands::CommandMaker;
using testing_commands::Numbers;
using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;

const Surface& sphere() {
  static const Surface surface = make_surface(Builtin::sphere, 1000);
  return surface;
}

/// evaluate() is not defined for commands that resolve refuses (too many dabs, too far); thousands of dabs only cost
/// time.
bool usable(const Command& command, const Surface& surface) {
  constexpr double max_dabs = 1000;
  const Result<Command> resolved = resolve(command, surface);
  if (!resolved.ok()) return false;
  return std::visit(
      [&](const auto& tool) {
        if constexpr (requires {
                        tool.stroke;
                        tool.brush;
                      })
          return !tool.stroke || BrushStroke(*tool.stroke, tool.brush, surface).dab_count() < max_dabs;
        return true;
      },
      *resolved);
}

/// Expects that the vertices of each part ascend and all change, and that values are in their field's range.
void expect_sound(const Evaluation& done, const FieldSet& before) {
  FieldSet after = before;
  after.apply(done.delta);
  for (const FieldDelta::Part& part : done.delta.parts) {
    const FieldShape& shape = shape_of(part.field);
    RC_ASSERT(std::is_sorted(part.vertices.begin(), part.vertices.end(), std::less_equal<>()));
    for (const std::uint32_t v : part.vertices) {
      const glm::vec4 value = after.value(part.field, v);
      RC_ASSERT(!(value == before.value(part.field, v)));
      for (int c = 0; c < shape.channels; ++c) RC_ASSERT(value[c] >= shape.min && value[c] <= shape.max);
      const glm::dvec2 direction(value);
      if (part.field == Field::direction) RC_ASSERT(glm::dot(direction, direction) <= 1.0);
    }
  }
}

/// A random model with fur, and a tool for it.
struct Try {
  Try(std::size_t tool, std::uint64_t seed, Numbers numbers)
      : random(seed),
        surface(testing_models::surface_of(testing_models::any_model(random))),
        make(seed, surface, numbers),
        command(make.command(tool)),
        before(make.fields()),
        baseline(make.fields()),
        coat(make.coat()) {}

  Evaluation evaluated(const Command& tool) const { return evaluate(tool, surface, before, {coat, &baseline}); }
  Evaluation evaluated() const { return evaluated(command); }
  bool good() const { return usable(command, surface); }

  Random random;
  Surface surface;
  CommandMaker make;
  Command command;
  FieldSet before, baseline;
  Coat coat;
};

class EveryTool : public ::testing::TestWithParam<std::size_t> {
 protected:
  /// Checks 100 random tries of the tool.
  template <class Check>
  void all(Numbers numbers, Check check) const {
    EXPECT_TRUE(rc::check("holds", [&](std::uint64_t seed) {
      const Try one(GetParam(), seed, numbers);
      if (one.good()) check(one);
    }));
  }
};

TEST_P(EveryTool, GivesFiniteFurAtEveryExtreme) {
  all(Numbers::extreme, [](const Try& one) { expect_sound(one.evaluated(), one.before); });
}

TEST_P(EveryTool, GivesTheSameBitsEveryTime) {
  all(Numbers::extreme, [](const Try& one) {
    const Evaluation first = one.evaluated(), second = one.evaluated();
    RC_ASSERT(first.delta == second.delta);
    RC_ASSERT(first.clamped == second.clamped);
  });
}

TEST_P(EveryTool, DoesNothingWithoutStrength) {
  all(Numbers::extreme, [](const Try& one) {
    Command weak = one.command;
    testing_commands::weaken(weak);
    if (auto* trim = std::get_if<Trim>(&weak); trim && trim->flood) return;  // a flood cuts completely
    if (std::holds_alternative<ChangeMask>(weak)) return;                    // it has no strength
    RC_ASSERT(one.evaluated(weak).delta.empty());
  });
}

TEST_P(EveryTool, IsUndoneByItsOwnDelta) {
  all(Numbers::extreme, [](const Try& one) {
    FieldSet fields = one.before;
    const FieldDelta delta = one.evaluated().delta;
    fields.apply(delta);
    RC_ASSERT((fields.hash() == one.before.hash()) == delta.empty());
    fields.apply(delta);
    RC_ASSERT(fields.hash() == one.before.hash());
  });
}

bool changes_the_mask(const Command& command) {
  const auto* paint = std::get_if<Paint>(&command);
  return std::holds_alternative<ChangeMask>(command) || (paint && paint->field == Field::mask);
}

TEST_P(EveryTool, ChangesNothingOutsideBrushAndMask) {
  all(Numbers::ordinary, [](const Try& one) {
    const plain::Stage stage{plain::Body(one.surface), one.coat, plain::read(one.baseline)};
    const plain::Fur fur = plain::read(one.before);
    std::visit(
        [&](const auto& tool) {
          if constexpr (requires { tool.stroke; }) {
            const bool masked = !changes_the_mask(one.command);
            const std::vector<double> region = plain::region_of(tool.stroke, tool.brush, stage, fur, masked);
            for (const std::uint32_t v : one.evaluated().delta.vertices()) RC_ASSERT(!tool.stroke || region[v] > 0);
            for (const std::uint32_t v : one.evaluated().delta.vertices())
              RC_ASSERT(!masked || one.before.number(Field::mask, v) > 0);
          }
        },
        one.command);
  });
}

TEST_P(EveryTool, ChangesNothingWhereTheMaskIsZero) {
  all(Numbers::extreme, [](const Try& one) {
    if (changes_the_mask(one.command)) return;
    FieldSet masked = one.before;
    for (std::uint32_t v = 0; v < masked.size(); ++v) masked.set(Field::mask, v, glm::vec4(0));
    RC_ASSERT(evaluate(one.command, one.surface, masked, {one.coat, &one.baseline}).delta.empty());
  });
}

INSTANTIATE_TEST_SUITE_P(Tools, EveryTool, ::testing::Range(std::size_t{0}, testing_commands::tool_count));

/// A straight stroke through points in internal coordinates, with `samples` + 1 samples.
Comb straight_comb(glm::dvec3 from, glm::dvec3 to, int samples, double radius) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= samples; ++i) points.push_back(glm::mix(from, to, static_cast<double>(i) / samples));
  Comb comb;
  comb.stroke = stroke_through(sphere(), points);
  comb.brush.radius = radius;
  return comb;
}

// A stroke of one second with 30 or with 240 samples: the dabs are the same but for rounding, so fields agree to 1e-6
// of an inclination (a few steps of a 32-bit number).
RC_GTEST_PROP(Comb, DoesNotDependOnTheSamplingRate, (std::uint64_t seed)) {
  Random random(seed);
  const auto near_surface = [&] {
    return 0.29 * glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.3, 1)));
  };
  const glm::dvec3 from = near_surface(), to = near_surface();
  const double radius = random.uniform(0.02, 0.3);
  const FieldSet fields = first_groom(sphere().mesh(), {});
  FieldSet slow = fields, fast = fields;
  slow.apply(evaluate(straight_comb(from, to, 30, radius), sphere(), fields).delta);
  fast.apply(evaluate(straight_comb(from, to, 240, radius), sphere(), fields).delta);
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    RC_ASSERT(glm::distance(glm::dvec2(slow.at(v).direction), glm::dvec2(fast.at(v).direction)) < 1e-6);
  }
}

RC_GTEST_PROP(Comb, MirroredStrokesGiveMirroredFur, (std::uint64_t seed)) {
  Random random(seed);
  const glm::dvec3 mirror(-1, 1, 1);
  const glm::dvec3 from(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.25);
  const glm::dvec3 to(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.25);
  const double radius = random.uniform(0.05, 0.2);
  const FieldSet fields = first_groom(sphere().mesh(), {.length = 0.03, .inclination = 0});
  FieldSet straight = fields, mirrored = fields;
  straight.apply(evaluate(straight_comb(from, to, 5, radius), sphere(), fields).delta);
  mirrored.apply(evaluate(straight_comb(mirror * from, mirror * to, 5, radius), sphere(), fields).delta);
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const glm::dvec3 position(sphere().mesh().positions[v]);
    std::vector<std::uint32_t> twin;
    sphere().vertices_within(mirror * position, 1e-6, twin);
    if (twin.size() != 1) continue;  // the mesh need not be symmetric everywhere
    const glm::dvec3 a = lean_of(sphere(), straight.at(v), v), b = lean_of(sphere(), mirrored.at(twin[0]), twin[0]);
    RC_ASSERT(glm::distance(mirror * a, b) < 1e-4);
  }
}

}  // namespace
}  // namespace pelage
