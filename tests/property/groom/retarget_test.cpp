// Fields and commands on random other models: soups, lone triangles, many parts, far away.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>

#include "server/groom/evaluate.h"
#include "server/surface/prepare.h"
#include "tests/property/groom/command_maker.h"
#include "tests/property/groom/models.h"

namespace pelage {
namespace {

using namespace testing_commands;
using testing_models::any_model;
using testing_models::surface_of;

void check_in_range(const FieldSet& fields) {
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      const FieldShape& shape = shape_of(field_at(f));
      for (int c = 0; c < shape.channels; ++c) {
        const float value = fields.value(field_at(f), v)[c];
        RC_ASSERT(value >= shape.least && value <= shape.most);
      }
    }
    const glm::dvec2 direction(fields.at(v).direction);
    RC_ASSERT(glm::dot(direction, direction) <= 1.0);
  }
}

Surface moved(RawModel raw, Random& random) {
  const double shift = random.uniform() < 0.3 ? 1e4 : 1, scale = std::pow(10, random.uniform(-3, 3));
  for (glm::dvec3& position : raw.positions)
    position = scale * position + shift * glm::dvec3(random.uniform() < 2, -0.4, 0.2);
  return surface_of(raw);
}

RC_GTEST_PROP(RetargetProperties, FieldsStayInRange, (std::uint64_t seed)) {
  Random random(seed, 9);
  const Surface source = moved(any_model(random), random), surface = moved(any_model(random), random);
  CommandMaker makes_source(seed, source, Numbers::extreme), makes(seed + 1, surface, Numbers::extreme);
  const FieldSet taken = makes_source.fields(), fields = makes.fields();
  Retarget command;
  command.align = random.uniform() < 0.5 ? Alignment::box : Alignment::none;
  command.strength = random.uniform() < 0.5 ? 1 : random.uniform();
  if (random.uniform() < 0.5) command.fields = {Field::direction, Field::mask, Field::root_colour};
  const Evaluation done = evaluate(command, surface, fields, {{}, &taken, &source});
  FieldSet result = fields;
  result.apply(done.delta);
  check_in_range(result);
  for (const std::uint32_t v : done.delta.vertices()) RC_ASSERT(fields.number(Field::mask, v) > 0);
}

RC_GTEST_PROP(RetargetProperties, CarriedCommandsRunOnTheOtherModel, (std::uint64_t seed)) {
  Random random(seed, 10);
  const Surface from = moved(any_model(random), random), to = moved(any_model(random), random);
  CommandMaker maker(seed, from, Numbers::ordinary);
  CommandMaker other(seed, to, Numbers::ordinary);
  const Command command = maker.command();
  const Result<Command> resolved = resolve(command, from);
  if (!resolved) return;
  const Result<Command> carried = carried_command(*resolved, from, to);
  if (!carried) {
    RC_ASSERT(!carried.status().pointer.empty());
    return;
  }
  RC_ASSERT(carried->index() == command.index());
  const Result<Command> there = resolve(*carried, to);
  if (!there) return;  // out of reach on a model of another build
  const FieldSet fields = other.fields(), rest = other.fields();
  FieldSet result = fields;
  result.apply(evaluate(*there, to, fields, {{}, &rest}).delta);
  check_in_range(result);
}

}  // namespace
}  // namespace pelage
