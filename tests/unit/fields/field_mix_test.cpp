// Fields interpolated between vertices and on subdivided triangles.
#include "server/fields/field_mix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "server/builtin/builtin.h"
#include "server/patches/subdivide.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

Mesh built_in(Builtin shape, int triangles) { return *prepare(make_builtin({shape, triangles})); }

/// Random values in every field.
FieldSet random_fields(std::size_t vertices) {
  Random random(5, 0);
  FieldSet fields(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      glm::vec4 value(0);
      for (int c = 0; c < shape_of(field_at(f)).channels; ++c) value[c] = static_cast<float>(random.uniform(-0.7, 0.7));
      if (f > 0) value = glm::abs(value);
      fields.set(field_at(f), v, value);
    }
  }
  return fields;
}

glm::dvec3 lean(const Mesh& mesh, const FieldSet& fields, std::uint32_t v) {
  const glm::dvec3 n(mesh.normals[v]), t(mesh.tangents[v]);
  const glm::dvec2 d(fields.at(v).direction);
  return d.x * t + d.y * glm::cross(n, t);
}

TEST(FieldMix, ASingleVertexGivesItsBits) {
  const Mesh mesh = built_in(Builtin::knot, 400);
  const FieldSet fields = random_fields(mesh.positions.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const std::uint32_t next = (v + 1) % static_cast<std::uint32_t>(fields.size());
    const MixShare shares[] = {{next, 0}, {v, 1}, {next, 0}};
    for (std::size_t f = 0; f < field_count; ++f)
      ASSERT_EQ(glm::vec4(mixed(fields, field_at(f), shares, mesh, mesh, v)), fields.value(field_at(f), v));
  }
}

TEST(FieldMix, ColoursCountByHowMuchTheyCover) {
  const Mesh mesh = built_in(Builtin::plane, 8);
  FieldSet fields(mesh.positions.size());
  fields.set(Field::tip_colour, 0, {1, 0, 0, 1});  // its neighbour's colour covers nothing
  const MixShare shares[] = {{0, 0.25}, {1, 0.75}};
  EXPECT_EQ(mixed(fields, Field::tip_colour, shares, mesh, mesh, 0), glm::dvec4(1, 0, 0, 0.25)) << "not darker";
  EXPECT_EQ(mixed(fields, Field::root_colour, shares, mesh, mesh, 0), glm::dvec4(0));
}

TEST(FieldMix, ADirectionKeepsItsInclinationOnAnotherPlane) {
  const Mesh mesh = built_in(Builtin::sphere, 400);
  const FieldSet fields = random_fields(mesh.positions.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const MixShare share[] = {{0, 1}};
    const glm::dvec4 there = mixed(fields, Field::direction, share, mesh, mesh, v);
    ASSERT_NEAR(glm::length(glm::dvec2(there)), glm::length(glm::dvec2(fields.at(0).direction)), 1e-6);
  }
}

TEST(FieldMix, FinerFieldsAreWhatWasThereAndTheMeansBetween) {
  const Mesh mesh = built_in(Builtin::sphere, 2000);
  const FieldSet fields = random_fields(mesh.positions.size());
  const auto finer = subdivide(mesh, lay_patches(mesh), {{0, static_cast<std::uint32_t>(mesh.triangles.size())}});
  const FieldSet result = subdivided(fields, mesh, finer->mesh, finer->parents);
  ASSERT_EQ(result.size(), finer->mesh.positions.size());
  const auto old = static_cast<std::uint32_t>(fields.size());
  for (std::uint32_t v = 0; v < old; ++v) {
    for (std::size_t f = 0; f < field_count; ++f) ASSERT_EQ(result.value(field_at(f), v), fields.value(field_at(f), v));
  }
  for (std::uint32_t k = 0; k < finer->parents.size(); ++k) {
    const auto [a, b] = std::pair(finer->parents[k].x, finer->parents[k].y);
    ASSERT_NEAR(result.number(Field::width, old + k),
                (fields.number(Field::width, a) + fields.number(Field::width, b)) / 2, 1e-6);
    const glm::dvec3 mean = (lean(mesh, fields, a) + lean(mesh, fields, b)) / 2.0;
    ASSERT_NEAR(glm::distance(lean(finer->mesh, result, old + k), mean), 0, 0.12) << "turned by half an edge's bend";
  }
}

TEST(FieldMix, FieldsAtTheirDefaultsStayThere) {
  const Mesh mesh = built_in(Builtin::plane, 8);
  const auto finer = subdivide(mesh, lay_patches(mesh), {{0, 2}});
  const FieldSet result = subdivided(FieldSet(mesh.positions.size()), mesh, finer->mesh, finer->parents);
  EXPECT_TRUE(result.at_default(Field::mask));
  EXPECT_EQ(result.hash(), FieldSet(finer->mesh.positions.size()).hash());
}

}  // namespace
}  // namespace pelage
