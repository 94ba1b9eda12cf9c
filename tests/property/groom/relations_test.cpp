// Relations that need no reference (science.md 7): moved, scaled, mirrored and renumbered models, symmetry, inverted
// tools.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numeric>
#include <sstream>

#include "server/groom/evaluate.h"
#include "server/groom/vertex_frame.h"
#include "tests/property/groom/command_maker.h"
#include "tests/property/groom/models.h"
#include "tests/property/groom/move_command.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_commands::CommandMaker;
using testing_commands::Motion;
using testing_commands::Numbers;
using testing_commands::tool_count;
using testing_commands::Views;
using testing_models::surface_of;

FieldSet after(const Command& command, const Surface& surface, const FieldSet& before, const FieldSet& baseline) {
  FieldSet fields = before;
  fields.apply(evaluate(command, surface, before, {{}, &baseline}).delta);
  return fields;
}

glm::dvec3 in_space(const Surface& surface, const FieldSet& fields, std::uint32_t v) {
  return testing_shapes::lean_of(surface, fields.at(v), v);
}

/// The same fur on a moved model: leans turn in space, everything else stays.
FieldSet moved_fields(const FieldSet& fields, const Surface& from, const Surface& to, const Motion& motion,
                      const std::vector<std::uint32_t>& new_indices) {
  FieldSet moved(fields.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    for (std::size_t f = 1; f < field_count; ++f) {
      glm::vec4 value = fields.value(field_at(f), v);
      if (field_at(f) == Field::length) value *= motion.scale * from.mesh().size / to.mesh().size;
      moved.set(field_at(f), new_indices[v], value);
    }
    const glm::dvec2 lean = frame_at(to.mesh(), new_indices[v]).tangent_part(motion.turn * in_space(from, fields, v));
    moved.set(Field::direction, new_indices[v], glm::vec4(stored_direction(lean), 0, 0));
  }
  return moved;
}

/// Returns where two grooms differ by more than the tolerance, or "". Up to `outliers` values may differ.
std::string difference_of(const FieldSet& expected, const FieldSet& found, double tolerance, std::size_t outliers = 0) {
  std::ostringstream text;
  for (std::size_t f = 0; f < field_count; ++f) {
    for (std::uint32_t v = 0; v < found.size(); ++v) {
      const glm::dvec4 a(expected.value(field_at(f), v)), b(found.value(field_at(f), v));
      if (glm::distance(a, b) <= tolerance * std::max(1.0, glm::length(a))) continue;
      if (outliers > 0) {
        --outliers;
        continue;
      }
      text << shape_of(field_at(f)).name << " of vertex " << v << ": " << b.x << " " << b.y << ", expected " << a.x
           << " " << a.y;
      return text.str();
    }
  }
  return {};
}

/// Noise and jitter depend on positions, so they differ on a moved model.
bool by_chance(const Command& command) {
  const auto* length = std::get_if<Length>(&command);
  return std::holds_alternative<Noise>(command) || (length && length->mode == LengthMode::jitter);
}

/// Returns whether a vertex just inside or outside changes the mask, so that rounding on a moved model would decide it.
bool has_hard_edge(const Command& command) {
  const auto* mask = std::get_if<ChangeMask>(&command);
  return mask != nullptr && (std::holds_alternative<MaskBox>(mask->shape) || mask->action == MaskAction::grow ||
                             mask->action == MaskAction::shrink);
}

/// Unless `turned` is false, the motion turns the model and gives it another bounding box and size.
Motion random_motion(Random& random, bool mirrored, bool turned) {
  const auto number = [&](double reach) { return random.uniform(-reach, reach); };
  Motion motion;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(number(1), number(1), number(1)) + 1e-3);
  if (turned) motion.turn = glm::dmat3(glm::rotate(glm::dmat4(1), number(3), axis));
  if (mirrored) motion.turn = motion.turn * glm::dmat3(glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)));
  motion.scale = std::exp(number(3));
  motion.shift = motion.scale * glm::dvec3(number(1), number(1), number(1));
  return motion;
}

/// The triangles of a prepared model, in model coordinates.
RawModel triangles_of(const Mesh& mesh) {
  RawModel raw;
  for (const glm::vec3 position : mesh.positions) raw.positions.push_back(mesh.to_model(position));
  for (const glm::uvec3 triangle : mesh.triangles) {
    raw.face_sizes.push_back(3);
    for (int k = 0; k < 3; ++k) raw.corners.push_back(triangle[k]);
  }
  return raw;
}

RawModel moved_model(RawModel raw, const Motion& motion) {
  for (glm::dvec3& position : raw.positions) position = motion.mapped(position);
  if (glm::determinant(motion.turn) > 0) return raw;
  auto face = raw.corners.begin();
  for (const std::uint32_t corners : raw.face_sizes) {
    std::reverse(face + 1, face + corners);
    face += corners;
  }
  return raw;
}

/// For each vertex, the index of the vertex that is at its moved position.
std::vector<std::uint32_t> moved_indices(const Mesh& from, const Mesh& to, const Motion& motion) {
  std::vector<std::uint32_t> new_indices;
  for (const glm::vec3 position : from.positions) {
    const glm::dvec3 moved_position = to.to_internal(motion.mapped(from.to_model(position)));
    const auto nearer = [&](glm::vec3 a, glm::vec3 b) {
      return glm::distance(glm::dvec3(a), moved_position) < glm::distance(glm::dvec3(b), moved_position);
    };
    const auto nearest = std::min_element(to.positions.begin(), to.positions.end(), nearer);
    new_indices.push_back(static_cast<std::uint32_t>(nearest - to.positions.begin()));
  }
  return new_indices;
}

/// Returns how a tool differs on a model that was turned, shifted, scaled and perhaps mirrored with all its lengths, or
/// "".
std::string difference_when_moved(std::size_t tool, std::uint64_t seed, bool mirrored) {
  Random random(seed);
  const RawModel raw = triangles_of(surface_of(testing_models::dented_builtin(random)).mesh());
  const bool flows =
      std::holds_alternative<Flow>(testing_commands::empty_tool(tool));  // steps in hundredths of the size
  const Motion motion = random_motion(random, mirrored, !flows);
  const Surface here = surface_of(raw), there = surface_of(moved_model(raw, motion));
  const std::vector<std::uint32_t> new_indices = moved_indices(here.mesh(), there.mesh(), motion);
  // A nearly flat open sheet has no outside: rounding may flip it when it is prepared again.
  const glm::dvec3 normal(there.mesh().normals[new_indices[0]]);
  if (glm::dot(motion.turn * glm::dvec3(here.mesh().normals[0]), normal) < 0) return {};
  CommandMaker make(seed, here, Numbers::ordinary, Views::none);
  const Command command = make.command(tool);
  if (by_chance(command) || has_hard_edge(command) || !resolve(command, here).ok()) return {};
  const Command moved = testing_commands::moved(command, motion, here, there, new_indices);
  const FieldSet before = make.fields(), baseline = make.fields();
  const FieldSet before_there = moved_fields(before, here, there, motion, new_indices),
                 baseline_there = moved_fields(baseline, here, there, motion, new_indices);
  const FieldSet expected = moved_fields(after(command, here, before, baseline), here, there, motion, new_indices);
  // 32-bit positions and normals are rounded again. Where a heading is nearly across the skin, rounding decides its
  // tangent direction.
  constexpr double tolerance = 2e-4;
  return difference_of(expected, after(moved, there, before_there, baseline_there), tolerance, 1 + before.size() / 50);
}

class ToolRelations : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ToolRelations, ModelsThatMoveAndGrowAreGroomedTheSame) {
  EXPECT_TRUE(rc::check("moved", [](std::uint64_t seed) {
    const std::string difference = difference_when_moved(GetParam(), seed, false);
    if (!difference.empty()) RC_FAIL(difference);
  }));
}

TEST_P(ToolRelations, MirroredModelsAreGroomedMirrored) {
  EXPECT_TRUE(rc::check("mirrored", [](std::uint64_t seed) {
    const std::string difference = difference_when_moved(GetParam(), seed, true);
    if (!difference.empty()) RC_FAIL(difference);
  }));
}

/// Shuffles the vertices of a model. Returns the new index of each vertex.
std::vector<std::uint32_t> shuffle(RawModel& raw, Random& random) {
  std::vector<std::uint32_t> new_indices(raw.positions.size());
  std::iota(new_indices.begin(), new_indices.end(), 0u);
  for (std::size_t k = new_indices.size(); k > 1; --k)
    std::swap(new_indices[k - 1], new_indices[static_cast<std::size_t>(random.uniform(0, static_cast<double>(k)))]);
  const std::vector<glm::dvec3> positions = raw.positions;
  for (std::size_t k = 0; k < new_indices.size(); ++k) raw.positions[new_indices[k]] = positions[k];
  for (std::uint32_t& corner : raw.corners) corner = new_indices[corner];
  return new_indices;
}

std::vector<std::uint32_t> same_indices(const Mesh& from, const Mesh& to) {
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  for (std::uint32_t v = 0; v < to.positions.size(); ++v)
    numbers[{to.positions[v].x, to.positions[v].y, to.positions[v].z}] = v;
  std::vector<std::uint32_t> new_indices;
  for (const glm::vec3 p : from.positions) new_indices.push_back(numbers.at({p.x, p.y, p.z}));
  return new_indices;
}

FieldSet renumbered(const FieldSet& fields, const std::vector<std::uint32_t>& new_indices) {
  FieldSet other(fields.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    for (std::size_t f = 0; f < field_count; ++f) other.set(field_at(f), new_indices[v], fields.value(field_at(f), v));
  }
  return other;
}

TEST_P(ToolRelations, NumbersOfVerticesDoNotMatter) {
  EXPECT_TRUE(rc::check("renumbered", [](std::uint64_t seed) {
    Random random(seed);
    RawModel raw = testing_models::dented_builtin(random);
    const Surface here = surface_of(raw);
    raw.length_scale.clear();
    shuffle(raw, random);
    const Surface there = surface_of(raw);
    const std::vector<std::uint32_t> new_indices = same_indices(here.mesh(), there.mesh());
    CommandMaker make(seed, here, Numbers::ordinary);
    Command command = make.command(GetParam());
    if (!resolve(command, here).ok()) return;
    const FieldSet before = make.fields(), baseline = make.fields();
    const FieldSet expected = renumbered(after(command, here, before, baseline), new_indices);
    testing_commands::renumber_vertices(command, new_indices);
    const FieldSet found = after(command, there, renumbered(before, new_indices), renumbered(baseline, new_indices));
    const std::string difference = difference_of(expected, found, 1e-5);
    if (!difference.empty()) RC_FAIL(difference);
  }));
}

INSTANTIATE_TEST_SUITE_P(Tools, ToolRelations, ::testing::Range(std::size_t{0}, tool_count));

}  // namespace
}  // namespace pelage
