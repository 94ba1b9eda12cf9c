// Every tool against its reference implementation, on random models, fur and commands.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "server/groom/evaluate.h"
#include "tests/property/groom/command_maker.h"
#include "tests/property/groom/models.h"
#include "tests/property/groom/reference/groomed.h"

namespace pelage {
namespace {

using testing_commands::CommandMaker;
using testing_commands::Numbers;
using testing_commands::tool_count;

/// Half a step of a 32-bit number plus the error of long sums: 3e-6 of the value or of 1, whichever is larger.
constexpr double tolerance = 3e-6;

std::string difference_of(const plain::Fur& expected, const FieldSet& found) {
  std::ostringstream text;
  for (std::size_t f = 0; f < field_count; ++f) {
    for (std::uint32_t v = 0; v < found.size(); ++v) {
      const glm::dvec4 a = expected.values[f][v], b(found.value(field_at(f), v));
      const double allowed = tolerance * std::max(1.0, glm::length(a));
      if (glm::distance(a, b) <= allowed) continue;
      text << shape_of(field_at(f)).name << " of vertex " << v << ": " << b.x << " " << b.y << " " << b.z << " " << b.w
           << ", expected " << a.x << " " << a.y << " " << a.z << " " << a.w;
      return text.str();
    }
  }
  return {};
}

bool by_heat(const Command& command) {
  if (const auto* keys = std::get_if<Interpolate>(&command)) return keys->distance == DistanceKind::heat;
  if (const auto* flow = std::get_if<Flow>(&command)) return flow->distance == DistanceKind::heat;
  return false;
}

/// Returns how the tool and the reference implementation differ, or "".
std::string disagreement(const Command& command, const Surface& surface, CommandMaker& make) {
  const Result<Command> resolved = resolve(command, surface);
  if (!resolved.ok() || by_heat(command)) return {};
  const FieldSet before = make.fields(), baseline = make.fields();
  const Coat coat = make.coat();
  FieldSet after = before;
  after.apply(evaluate(*resolved, surface, before, {coat, &baseline}).delta);
  const plain::Stage stage{plain::Body(surface), coat, plain::read(baseline)};
  const std::string difference = difference_of(plain::groomed(*resolved, stage, plain::read(before)), after);
  return difference.empty() ? difference : op_of(command) + (": " + difference);
}

class ToolAgainstReference : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ToolAgainstReference, AgreesOnRandomModels) {
  EXPECT_TRUE(rc::check("agrees", [](std::uint64_t seed) {
    Random random(seed);
    const Surface surface = testing_models::surface_of(testing_models::any_model(random));
    CommandMaker make(seed, surface, Numbers::ordinary);
    const std::string difference = disagreement(make.command(GetParam()), surface, make);
    if (!difference.empty()) RC_FAIL(difference);
  }));
}

INSTANTIATE_TEST_SUITE_P(Tools, ToolAgainstReference, ::testing::Range(std::size_t{0}, tool_count));

}  // namespace
}  // namespace pelage
