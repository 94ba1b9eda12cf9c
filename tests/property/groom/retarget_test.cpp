// Retargets fields and commands to random other models: soups, lone triangles, many parts, models far away.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "server/fields/field_mix.h"
#include "server/groom/evaluate.h"
#include "server/patches/subdivide.h"
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
        RC_ASSERT(value >= shape.min && value <= shape.max);
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

RC_GTEST_PROP(RetargetProperties, TheSameModelGivesTheBitsBack, (std::uint64_t seed)) {
  Random random(seed, 11);
  const Surface surface = moved(any_model(random), random);
  CommandMaker maker(seed, surface, Numbers::ordinary);
  const FieldSet taken = maker.fields();
  Retarget command;
  command.align = random.uniform() < 0.5 ? Alignment::box : Alignment::none;
  for (std::size_t f = 0; f < field_count; ++f) command.fields.push_back(field_at(f));
  FieldSet result(taken.size());
  result.apply(evaluate(command, surface, result, {{}, &taken, &surface}).delta);
  RC_ASSERT(difference(result, taken).empty());
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

RC_GTEST_PROP(SubdivideProperties, AnyModelAndChoice, (std::uint64_t seed)) {
  Random random(seed, 12);
  const Surface surface = moved(any_model(random), random);
  const Mesh& mesh = surface.mesh();
  CommandMaker maker(seed, surface, Numbers::extreme);
  const FieldSet fields = maker.fields();
  ChosenTriangles chosen;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (random.uniform() < 0.3 && (chosen.empty() || chosen.back().end < t)) chosen.push_back({t, t + 1});
  }
  const auto finer = subdivide(mesh, lay_patches(mesh), chosen);
  RC_ASSERT(finer.ok());
  RC_ASSERT(std::abs(area_of(finer->mesh) - area_of(mesh)) <= 1e-6 * (1 + area_of(mesh)));
  std::vector<glm::dvec3> shares(finer->mesh.triangles.size(), glm::dvec3(0));
  for (const PatchTriangle& patch_triangle : finer->patches.patch_triangles) {
    for (int k = 0; k < 3; ++k)
      shares[patch_triangle.triangle][k] += double{finer->patches.points[patch_triangle.points[k]].weight};
  }
  for (const glm::dvec3& share : shares) RC_ASSERT(glm::length(share - 1.0) < 1e-5);
  for (std::size_t v = 0; v < finer->mesh.positions.size(); ++v) {
    const glm::vec3 normal = finer->mesh.normals[v], tangent = finer->mesh.tangents[v];
    RC_ASSERT(std::abs(glm::length(normal) - 1) < 1e-5f && std::abs(glm::length(tangent) - 1) < 1e-5f);
    RC_ASSERT(std::abs(glm::dot(normal, tangent)) < 1e-5f);
  }
  check_in_range(subdivided(fields, mesh, finer->mesh, finer->parents));
}

RC_GTEST_PROP(RetargetProperties, TransferredCommandsRunOnTheOtherModel, (std::uint64_t seed)) {
  Random random(seed, 10);
  const Surface from = moved(any_model(random), random), to = moved(any_model(random), random);
  CommandMaker maker(seed, from, Numbers::ordinary);
  CommandMaker other(seed, to, Numbers::ordinary);
  const Command command = maker.command();
  const Result<Command> resolved = resolve(command, from);
  if (!resolved) return;
  const Result<Command> transferred = transferred_command(*resolved, from, to);
  if (!transferred) {
    RC_ASSERT(!transferred.status().pointer.empty());
    return;
  }
  RC_ASSERT(transferred->index() == command.index());
  const Result<Command> there = resolve(*transferred, to);
  if (!there) return;  // may be out of reach on a different model
  const FieldSet fields = other.fields(), baseline = other.fields();
  FieldSet result = fields;
  result.apply(evaluate(*there, to, fields, {{}, &baseline}).delta);
  check_in_range(result);
}

}  // namespace
}  // namespace pelage
