// Retargets fields and commands to another model.
#include "server/groom/retarget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"
#include "server/fields/field_mix.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/patches/subdivide.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;

/// Fields that all vary smoothly over the body.
FieldSet smooth_fields(const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  FieldSet fields = first_groom(mesh, {});
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    fields.set(Field::length, v, glm::vec4(0.05f + 0.04f * p.z, 0, 0, 0));
    fields.set(Field::density, v, glm::vec4(0.5f + 0.4f * p.x, 0, 0, 0));
    fields.set(Field::tip_colour, v, glm::vec4(0.5f + p, 0.5f + 0.3f * p.y));
  }
  return fields;
}

FieldSet retargeted(const Retarget& command, const Surface& surface, const FieldSet& fields, const Surface& source,
                    const FieldSet& taken) {
  FieldSet result = fields;
  result.apply(evaluate(command, surface, fields, {{}, &taken, &source}).delta);
  return result;
}

Surface moved(Builtin shape, int triangles, glm::dvec3 scale, glm::dvec3 shift) {
  RawModel raw = make_builtin({shape, triangles});
  for (glm::dvec3& position : raw.positions) position = scale * position + shift;
  return Surface(*prepare(raw));
}

TEST(Retarget, TheSameModelGivesTheBitsBack) {
  for (const Builtin shape : {Builtin::torus, Builtin::knot, Builtin::creature}) {
    const Surface surface = make_surface(shape, 2000);
    const FieldSet source = smooth_fields(surface);
    for (const Alignment align : {Alignment::box, Alignment::none}) {
      Retarget command;
      command.align = align;
      const FieldSet result = retargeted(command, surface, FieldSet(source.size()), surface, source);
      EXPECT_EQ(result.hash(), source.hash());
      EXPECT_TRUE(evaluate(command, surface, source, {{}, &source, &surface}).delta.empty());
    }
  }
}

TEST(Retarget, FinerTrianglesTakeWhatSubdividingGives) {
  const Surface surface = make_surface(Builtin::creature, 1500);
  const FieldSet source = smooth_fields(surface);
  const Mesh& mesh = surface.mesh();
  auto finer = subdivide(mesh, lay_patches(mesh), {{0, static_cast<std::uint32_t>(mesh.triangles.size())}});
  const FieldSet expected = subdivided(source, mesh, finer->mesh, finer->parents);
  const Surface fine(std::move(finer->mesh));
  const FieldSet result = retargeted({}, fine, FieldSet(expected.size()), surface, source);
  double worst = 0;
  for (std::uint32_t v = 0; v < expected.size(); ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      const glm::vec4 difference = result.value(field_at(f), v) - expected.value(field_at(f), v);
      worst = std::max(worst, double{glm::length(difference)});
    }
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(Retarget, BoxesAreLaidOverEachOtherAndLengthsStayShares) {
  const Surface source = make_surface(Builtin::sphere, 4000);
  const Surface tall = moved(Builtin::sphere, 4000, {20, 60, 20}, {500, 0, -90});
  const FieldSet taken = smooth_fields(source);
  const FieldSet result = retargeted({}, tall, FieldSet(tall.mesh().positions.size()), source, taken);
  for (std::uint32_t v = 0; v < result.size(); ++v) {
    ASSERT_NEAR(result.number(Field::length, v), taken.number(Field::length, v), 1e-4);
    ASSERT_NEAR(result.number(Field::density, v), taken.number(Field::density, v), 1e-3);
    const glm::vec2 before = taken.at(v).direction, after = result.at(v).direction;
    ASSERT_NEAR(glm::length(after), glm::length(before), 0.02) << "inclinations stay";
  }
}

TEST(Retarget, WithoutAlignmentLengthsStayAsLongAsTheyAre) {
  const Surface source = make_surface(Builtin::sphere, 2000);
  const Surface twice = moved(Builtin::sphere, 2000, glm::dvec3(2), glm::dvec3(0));
  Retarget command;
  command.align = Alignment::none;
  command.fields = {Field::length};
  FieldSet taken(source.mesh().positions.size());
  for (std::uint32_t v = 0; v < taken.size(); ++v) taken.set(Field::length, v, {0.08f, 0, 0, 0});
  const FieldSet result = retargeted(command, twice, FieldSet(taken.size()), source, taken);
  for (std::uint32_t v = 0; v < result.size(); ++v) ASSERT_NEAR(result.number(Field::length, v), 0.04f, 1e-6);
}

TEST(Retarget, FarVerticesAreCountedInAWarning) {
  const Surface source = make_surface(Builtin::sphere, 2000);
  const FieldSet taken(source.mesh().positions.size());
  Retarget command;
  command.align = Alignment::none;
  const auto warnings = [&](const Surface& target) {
    const FieldSet fields(target.mesh().positions.size());
    return evaluate(command, target, fields, {{}, &taken, &source}).warnings;
  };
  EXPECT_TRUE(warnings(source).empty());
  const Surface away = moved(Builtin::sphere, 2000, glm::dvec3(1), glm::dvec3(10, 0, 0));
  const std::string all = std::to_string(away.mesh().positions.size());
  ASSERT_EQ(warnings(away).size(), 1u);
  EXPECT_EQ(warnings(away)[0].substr(0, 2 * all.size() + 4), all + " of " + all);
}

/// The nearest point by brute force: projects onto each triangle, or onto its sides if the projection is outside.
struct PlainNearest {
  double distance = 1e9;
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
};

void try_position(PlainNearest& best, std::uint32_t t, const std::array<glm::dvec3, 3>& p, glm::dvec3 position,
                  glm::dvec3 barycentric) {
  const double distance = glm::distance(position, barycentric.x * p[0] + barycentric.y * p[1] + barycentric.z * p[2]);
  if (distance < best.distance) best = {distance, t, barycentric};
}

PlainNearest plain_nearest(const Mesh& mesh, glm::dvec3 position) {
  PlainNearest best;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<glm::dvec3, 3> p;
    for (int k = 0; k < 3; ++k)
      p[static_cast<std::size_t>(k)] = mesh.to_model(glm::dvec3(mesh.positions[mesh.triangles[t][k]]));
    const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    glm::dvec3 inside;
    for (std::size_t k = 0; k < 3; ++k)
      inside[static_cast<int>(k)] =
          glm::dot(glm::cross(p[(k + 2) % 3] - p[(k + 1) % 3], position - p[(k + 1) % 3]), n) / glm::dot(n, n);
    if (inside.x >= 0 && inside.y >= 0 && inside.z >= 0) try_position(best, t, p, position, inside);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 side = p[(k + 1) % 3] - p[k];
      const double along = std::clamp(glm::dot(position - p[k], side) / glm::dot(side, side), 0.0, 1.0);
      glm::dvec3 on_side(0);
      on_side[static_cast<int>(k)] = 1 - along, on_side[static_cast<int>((k + 1) % 3)] = along;
      try_position(best, t, p, position, on_side);
    }
  }
  return best;
}

// Checks against a brute-force search over all triangles, in model coordinates.
TEST(Retarget, TakesWhatLiesAtTheNearestPositionInModelCoordinates) {
  const Surface source = make_surface(Builtin::sphere, 500);
  const FieldSet taken = smooth_fields(source);
  for (const Alignment align : {Alignment::none, Alignment::box}) {
    const Surface surface = moved(Builtin::creature, 600, glm::dvec3(1.7), {0.3, -0.8, 0.2});
    const Mesh &mesh = surface.mesh(), &other = source.mesh();
    Retarget command;
    command.align = align;
    const FieldSet result = retargeted(command, surface, FieldSet(mesh.positions.size()), source, taken);
    const glm::dvec3 ratio =
        (other.report.bounds.max - other.report.bounds.min) / (mesh.report.bounds.max - mesh.report.bounds.min);
    for (std::uint32_t v = 0; v < result.size(); ++v) {
      glm::dvec3 position = mesh.to_model(glm::dvec3(mesh.positions[v]));
      if (align == Alignment::box) position = (position - mesh.report.bounds.min) * ratio + other.report.bounds.min;
      const PlainNearest nearest = plain_nearest(other, position);
      double density = 0, length = 0;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t corner = other.triangles[nearest.triangle][k];
        density += nearest.barycentric[k] * taken.number(Field::density, corner);
        length += nearest.barycentric[k] * taken.number(Field::length, corner);
      }
      if (align == Alignment::none) length *= other.size / mesh.size;
      ASSERT_NEAR(result.number(Field::density, v), density, 2e-5) << v;
      ASSERT_NEAR(result.number(Field::length, v), length, 2e-5) << v;
    }
  }
}

TEST(Retarget, ObeysTheMaskAndItsFieldsAndItsStrength) {
  const Surface surface = make_surface(Builtin::torus, 800);
  const FieldSet source = smooth_fields(surface);
  FieldSet fields(source.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v)
    fields.set(Field::mask, v, glm::vec4(static_cast<float>(v % 3) / 2, 0, 0, 0));
  Retarget command;
  command.fields = {Field::density};
  command.strength = 0.5;
  const FieldDelta delta = evaluate(command, surface, fields, {{}, &source, &surface}).delta;
  ASSERT_EQ(delta.parts.size(), 1u);
  EXPECT_EQ(delta.parts[0].field, Field::density);
  FieldSet result = fields;
  result.apply(delta);
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const double weight = 0.5 * (v % 3) / 2;
    ASSERT_NEAR(result.number(Field::density, v), (1 - weight) + weight * source.number(Field::density, v), 1e-6);
  }
  for (std::uint32_t v = 0; v < fields.size(); ++v) fields.set(Field::mask, v, glm::vec4(0));
  EXPECT_TRUE(evaluate(Retarget{}, surface, fields, {{}, &source, &surface}).delta.empty());
  EXPECT_TRUE(
      evaluate(Retarget{.strength = 0}, surface, FieldSet(source.size()), {{}, &source, &surface}).delta.empty());
}

FieldSet groomed(const std::vector<Command>& commands, const Surface& surface) {
  FieldSet fields = first_groom(surface.mesh(), {});
  for (const Command& command : commands) fields.apply(evaluate(command, surface, fields).delta);
  return fields;
}

/// Tools with all kinds of positions, and lengths in the model's unit.
std::vector<Command> log_on(const Surface& surface) {
  const double unit = surface.mesh().size;
  const auto at = [&](double x, double y, double z) {
    return surface.mesh().to_model(surface.position(surface.nearest({x, y, z})));
  };
  std::vector<Command> log;
  Comb comb;
  comb.stroke = stroke_through(surface, {{0.2, 0.2, 0.1}, {0.25, 0.1, 0.0}, {0.2, 0, -0.1}});
  comb.stroke->samples.push_back({SurfaceSample{7, {0.2, 0.3, 0.5}}});
  comb.brush.radius = 0.11 * unit, comb.brush.units = RadiusUnits::world;
  log.emplace_back(comb);
  Blow blow;
  blow.source = at(0.3, 0.1, 0.4) + glm::dvec3(0, 0.2, 0.1) * unit, blow.direction = {0.1, -1, 0.2};
  blow.fall = 0.4 * unit, blow.units = Units::world;
  log.emplace_back(blow);
  log.emplace_back(Attract{.point = at(-0.3, 0.1, 0.2), .radius = 0.2 * unit, .units = Units::world});
  Interpolate keys;
  keys.keys = {{at(0, 0.3, 0), glm::dvec3(1, 0, 0), 0.5, 0.06 * unit}, {at(0, -0.3, 0.1), {}, {}, 0.02 * unit}};
  keys.units = Units::world, keys.sigma = 0.2 * unit;
  log.emplace_back(keys);
  ChangeMask mask;
  mask.shape = MaskSphere{at(0.1, 0.1, 0.3), 0.3 * unit, 0.5}, mask.units = Units::world;
  log.emplace_back(mask);
  log.emplace_back(Trim{
      .flood = true, .shape = TrimSphere{surface.mesh().to_model({0, 0, 0}), 0.3 * unit, true}, .units = Units::world});
  log.emplace_back(
      ChangeMask{.shape = MaskBox{surface.mesh().to_model({-1, -1, -1}), surface.mesh().to_model({0.0123, 1, 1})}});
  log.emplace_back(Length{.flood = true, .mode = LengthMode::add, .value = 0.01 * unit, .units = Units::world});
  return log;
}

std::vector<Command> transferred_log(const std::vector<Command>& log, const Surface& from, const Surface& to) {
  std::vector<Command> transferred;
  for (const Command& command : log) {
    Result<Command> one = transferred_command(command, from, to);
    EXPECT_TRUE(one.ok()) << one.status().message;
    if (one) transferred.push_back(std::move(*one));
  }
  return transferred;
}

TEST(TransferredLog, AScaledCopyGetsTheSameGroomToTheBit) {
  for (const Builtin shape : {Builtin::torus, Builtin::creature}) {
    const Surface from = make_surface(shape, 1500), to = moved(shape, 1500, glm::dvec3(8), glm::dvec3(0));
    const std::vector<Command> log = log_on(from);
    const FieldSet expected = groomed(log, from);
    EXPECT_NE(expected.hash(), groomed({}, from).hash());
    EXPECT_EQ(groomed(transferred_log(log, from, to), to).hash(), expected.hash());
    EXPECT_NE(groomed(log, to).hash(), expected.hash()) << "without the transfer it is another groom";
  }
}

TEST(TransferredLog, AMovedCopyOfAnySizeGetsTheSameGroom) {
  // Avoids a model with points equally far from several vertices, where rounding would choose another vertex.
  const Surface from = make_surface(Builtin::creature, 1500);
  const Surface to = moved(Builtin::creature, 1500, glm::dvec3(3.7), {40, -7, 11});
  const std::vector<Command> log = log_on(from);
  const FieldSet expected = groomed(log, from), result = groomed(transferred_log(log, from, to), to);
  for (std::uint32_t v = 0; v < expected.size(); ++v) {
    ASSERT_NEAR(glm::distance(lean_of(from, expected.at(v), v), lean_of(to, result.at(v), v)), 0, 1e-5);
    ASSERT_NEAR(expected.at(v).length, result.at(v).length, 1e-5);
    ASSERT_NEAR(expected.number(Field::mask, v), result.number(Field::mask, v), 1e-5);
  }
}

TEST(TransferredLog, PositionsLieOnTheSkinOfAnotherBuild) {
  const Surface from = make_surface(Builtin::sphere, 2000), to = make_surface(Builtin::torus, 2000);
  Comb comb;
  comb.stroke = stroke_through(from, {});
  for (std::uint32_t t = 0; t < 60; t += 7) {
    comb.stroke->samples.push_back({SurfaceSample{t, {0.2, 0.3, 0.5}}});
    const glm::dvec3 skin = from.position({t, {0.2, 0.3, 0.5}});
    comb.stroke->samples.push_back(
        {PositionSample{from.mesh().to_model(skin + 0.05 * from.normal({t, {0.2, 0.3, 0.5}}))}});
  }
  comb.stroke->view = View{};
  comb.brush.units = RadiusUnits::pixels, comb.brush.radius = 30, comb.brush.falloff_shape = FalloffShape::screen;
  const auto transferred = transferred_command(comb, from, to);
  ASSERT_TRUE(transferred.ok());
  const Comb& result = std::get<Comb>(*transferred);
  EXPECT_FALSE(result.stroke->view);
  EXPECT_EQ(result.brush.units, RadiusUnits::relative);
  EXPECT_EQ(result.brush.falloff_shape, FalloffShape::volume);
  EXPECT_TRUE(resolve(*transferred, to).ok());
  for (const StrokeSample& sample : result.stroke->samples) {
    if (const auto* in_space = std::get_if<PositionSample>(&sample.position)) {
      const glm::dvec3 p = to.mesh().to_internal(in_space->position);
      EXPECT_LT(glm::distance(p, to.position(to.nearest(p))), 0.1) << "as near the skin as it was";
    }
  }
}

TEST(TransferredLog, SettingsGoAlong) {
  const Surface from = make_surface(Builtin::sphere, 500);
  const Surface to = moved(Builtin::sphere, 500, glm::dvec3(4), glm::dvec3(0));
  const glm::dvec3 root = from.mesh().to_model(glm::dvec3(from.mesh().positions[3]));
  const auto near = [](glm::dvec3 a, glm::dvec3 b) { EXPECT_NEAR(glm::distance(a, b), 0, 1e-9); };
  SetCurves curves;
  curves.groups.resize(1);
  curves.groups[0].curves = {{root, root * 1.5}};
  const auto whiskers = transferred_command(curves, from, to);
  near(std::get<SetCurves>(*whiskers).groups[0].curves[0][1], 4.0 * 1.5 * root);
  Eye eye;
  eye.position = root, eye.look_at = glm::dvec3(0, 0, 5);
  const auto eyes = transferred_command(SetEyes{{eye}}, from, to);
  near(std::get<SetEyes>(*eyes).eyes[0].position, 4.0 * root);
  near(*std::get<SetEyes>(*eyes).eyes[0].look_at, {0, 0, 20});
  EXPECT_EQ(std::get<SetEyes>(*eyes).eyes[0].radius, eye.radius) << "it is a share of the size";
  SkinRegion region;
  region.centre = root;
  const auto skin = transferred_command(SetSkin{{region}}, from, to);
  near(std::get<SetSkin>(*skin).regions[0].centre, 4.0 * root);
  Symmetry symmetry;
  symmetry.planes = {{{0.5, 0, 0}, {1, 0, 0}}};
  const auto mirror = transferred_command(SetSymmetry{symmetry}, from, to);
  near(std::get<SetSymmetry>(*mirror).symmetry.planes[0].point, {2, 0, 0});
  const auto winds =
      transferred_command(SetBlowers{{{"fan", Blow{.source = {0, 1, 0}, .fall = 2, .units = Units::world}}}}, from, to);
  near(std::get<SetBlowers>(*winds).blowers[0].blow.source, {0, 4, 0});
  EXPECT_DOUBLE_EQ(std::get<SetBlowers>(*winds).blowers[0].blow.fall, 8);
}

TEST(TransferredLog, WhatNamesVerticesOrRevisionsIsRefused) {
  const Surface from = make_surface(Builtin::sphere, 100), to = make_surface(Builtin::torus, 100);
  EXPECT_EQ(transferred_command(ChangeMask{.shape = MaskVertices{{1}}}, from, to).status().pointer, "/vertices");
  EXPECT_EQ(transferred_command(Erase{.flood = true, .revision = 3}, from, to).status().pointer, "/revision");
  EXPECT_EQ(transferred_command(Checkpoint{"a", 2}, from, to).status().pointer, "/revision");
  EXPECT_TRUE(transferred_command(Checkpoint{"a", {}}, from, to).ok());
}

TEST(TransferredLog, BoxesOfUnlikeShapeTurnDirections) {
  const Surface from = make_surface(Builtin::sphere, 100);
  const Surface tall = moved(Builtin::sphere, 100, {1, 3, 1}, glm::dvec3(0));
  Comb comb;
  comb.flood = true, comb.direction = glm::dvec3(1, 1, 0);
  const glm::dvec3 turned = *std::get<Comb>(*transferred_command(comb, from, tall)).direction;
  EXPECT_NEAR(turned.y / turned.x, 3, 1e-5);
  const Trim trim{.flood = true, .shape = TrimPlane{{0, 0, 0}, {1, 1, 0}}};
  const Command flat = *transferred_command(trim, from, tall);
  const glm::dvec3 normal = std::get<TrimPlane>(std::get<Trim>(flat).shape).normal;
  EXPECT_NEAR(glm::dot(normal, turned * glm::dvec3(1, -1, 1)), 0, 1e-5) << "what lay in the plane lies in it";
}

}  // namespace
}  // namespace pelage
