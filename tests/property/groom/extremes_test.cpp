// Extreme strokes and models: strokes that cancel, folds, opposite neighbours, keys that cannot be reached, ten
// thousand passes, brushes of no size and of any size. Fur stays finite and in range, and each case has the effect that
// it should have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/builtin/builtin.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/groom/vertex_frame.h"
#include "tests/property/groom/models.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_models::surface_of;
using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;

FieldSet after(const Command& command, const Surface& surface, const FieldSet& before) {
  FieldSet fields = before;
  fields.apply(evaluate(command, surface, before).delta);
  return fields;
}

void expect_in_range(const FieldSet& fields) {
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      const FieldShape& shape = shape_of(field_at(f));
      for (int c = 0; c < shape.channels; ++c) {
        const float value = fields.value(field_at(f), v)[c];
        ASSERT_TRUE(value >= shape.min && value <= shape.max) << shape.name << " of vertex " << v << ": " << value;
      }
    }
    const glm::dvec2 direction(fields.at(v).direction);
    ASSERT_LE(glm::dot(direction, direction), 1.0);
  }
}

/// Two triangles that share an edge and are folded almost flat onto each other.
Surface folded() {
  RawModel raw;
  raw.positions = {{0, 0, 0}, {0, 0, 1}, {1, 1e-4, 0.5}, {1, -1e-4, 0.5}};
  raw.corners = {0, 1, 2, 1, 0, 3};
  raw.face_sizes = {3, 3};
  return surface_of(raw);
}

/// Two separate balls.
Surface two_balls() {
  RawModel raw = make_builtin({Builtin::sphere, 200});
  const std::size_t count = raw.positions.size();
  const std::vector<std::uint32_t> corners = raw.corners;
  for (std::size_t k = 0; k < count; ++k) raw.positions.push_back(raw.positions[k] + glm::dvec3(4, 0, 0));
  for (const std::uint32_t corner : corners) raw.corners.push_back(corner + static_cast<std::uint32_t>(count));
  const std::vector<std::uint32_t> sizes = raw.face_sizes;
  raw.face_sizes.insert(raw.face_sizes.end(), sizes.begin(), sizes.end());
  raw.length_scale.clear();
  return surface_of(raw);
}

Smooth flood_smooth(int passes, std::vector<Field> fields) {
  Smooth smooth;
  smooth.flood = true;
  smooth.brush.strength = 1;
  smooth.passes = passes;
  smooth.fields = std::move(fields);
  return smooth;
}

TEST(Extremes, AStrokeThereAndBackLeavesFiniteFurThatLeansBack) {
  const Surface sphere = make_surface(Builtin::sphere, 1000);
  const FieldSet before = first_groom(sphere.mesh(), {});
  Comb comb;
  comb.stroke = stroke_through(sphere, {{-0.1, 0, 0.28}, {0.1, 0, 0.28}, {-0.1, 0, 0.28}});
  comb.brush = {.radius = 0.1, .strength = 1};
  const FieldSet combed = after(comb, sphere, before);
  expect_in_range(combed);
  const std::uint32_t front = testing_shapes::vertex_towards(sphere, {0, 0, 1});
  EXPECT_LT(lean_of(sphere, combed.at(front), front).x, -0.1);  // the last dabs weigh most
}

TEST(Extremes, OppositeNeighboursSmoothToATuftOrKeepTheirInclination) {
  const Surface plane = make_surface(Builtin::plane, 200);
  FieldSet before(plane.mesh().positions.size());
  for (std::uint32_t v = 0; v < before.size(); ++v)
    before.set(Field::direction, v, glm::vec4(plane.mesh().positions[v].x < 0 ? -1 : 1, 0, 0, 0));
  Smooth smooth = flood_smooth(10, {Field::direction});
  const FieldSet tuft = after(smooth, plane, before);
  expect_in_range(tuft);
  smooth.keep_inclination = true;
  const FieldSet inclined = after(smooth, plane, before);
  float min = 1, min_inclined = 1;
  for (std::uint32_t v = 0; v < before.size(); ++v) {
    min = std::min(min, glm::length(tuft.at(v).direction));
    min_inclined = std::min(min_inclined, glm::length(inclined.at(v).direction));
  }
  EXPECT_LT(min, 0.6f);
  EXPECT_GT(min_inclined, 1 - 1e-5f);
}

TEST(Extremes, FurOnAFoldIsSmoothedAndSpreadFinitely) {
  const Surface fold = folded();
  ASSERT_EQ(fold.mesh().positions.size(), 4u);
  FieldSet before = first_groom(fold.mesh(), {});
  before.set(Field::direction, 0, glm::vec4(1, 0, 0, 0));
  before.set(Field::direction, 2, glm::vec4(-1, 0, 0, 0));
  expect_in_range(after(flood_smooth(100, {Field::direction}), fold, before));
  for (const DistanceKind kind : {DistanceKind::straight, DistanceKind::dijkstra, DistanceKind::heat}) {
    Interpolate keys;
    keys.distance = kind;
    keys.keys = {
        Key{.position = fold.mesh().to_model({0.3, 0.1, 0}), .direction = glm::dvec3(1, 0, 0.2), .inclination = 1}};
    const FieldSet spread = after(keys, fold, before);
    expect_in_range(spread);
    for (std::uint32_t v = 0; v < spread.size(); ++v) EXPECT_NEAR(glm::length(spread.at(v).direction), 1, 1e-5);
  }
}

TEST(Extremes, WhatNoKeyReachesKeepsItsFur) {
  const Surface balls = two_balls();
  const FieldSet before = first_groom(balls.mesh(), {});
  for (const DistanceKind kind : {DistanceKind::dijkstra, DistanceKind::heat}) {
    Interpolate keys;
    keys.distance = kind;
    keys.keys = {Key{.position = balls.mesh().to_model({-0.5, 0, 0}), .direction = glm::dvec3(0, 1, 0), .length = 0.5}};
    Flow flow;
    flow.distance = kind;
    flow.curves = {{balls.mesh().to_model({-0.5, -0.1, 0}), balls.mesh().to_model({-0.5, 0.1, 0})}};
    for (const Command& command : {Command(keys), Command(flow)}) {
      const FieldDelta delta = evaluate(command, balls, before).delta;
      ASSERT_FALSE(delta.empty());
      for (const std::uint32_t v : delta.vertices()) ASSERT_LT(balls.mesh().positions[v].x, 0) << op_of(command);
    }
  }
}

TEST(Extremes, KeysOfTheLeastWidthTakeTheNearestOnesValue) {
  const Surface sphere = make_surface(Builtin::sphere, 1000);
  const FieldSet before = first_groom(sphere.mesh(), {});
  Interpolate keys;
  keys.sigma = 1e-6;
  keys.distance = DistanceKind::straight;
  keys.keys = {Key{.position = sphere.mesh().to_model({-0.3, 0.013, 0.041}), .length = 0.25},
               Key{.position = sphere.mesh().to_model({0.3, 0.029, -0.017}), .length = 0.5}};
  const FieldSet spread = after(keys, sphere, before);
  std::size_t short_ones = 0;
  for (const float length : spread.length()) {
    ASSERT_TRUE(length == 0.25f || length == 0.5f) << length;
    short_ones += length == 0.25f;
  }
  EXPECT_NEAR(static_cast<double>(short_ones) / static_cast<double>(spread.size()), 0.5, 0.1);
}

// A value that is the same everywhere is not changed by smoothing.
TEST(Extremes, TenThousandPassesKeepWhatIsEven) {
  const Surface sphere = make_surface(Builtin::sphere, 500);
  FieldSet before = first_groom(sphere.mesh(), {});
  for (std::uint32_t v = 0; v < before.size(); ++v) {
    before.set(Field::length, v, glm::vec4(0.03f, 0, 0, 0));
    before.set(Field::density, v, glm::vec4(0.7f, 0, 0, 0));
    before.set(Field::width, v, glm::vec4(4, 0, 0, 0));
  }
  const Evaluation done = evaluate(flood_smooth(10'000, {Field::length, Field::density, Field::width}), sphere, before);
  EXPECT_EQ(done.clamped, 0u);
  FieldSet fields = before;
  fields.apply(done.delta);
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    ASSERT_NEAR(fields.at(v).length, 0.03, 1e-7);
    ASSERT_NEAR(fields.number(Field::density, v), 0.7, 1e-6);
    ASSERT_NEAR(fields.number(Field::width, v), 4, 1e-6);
  }
}

TEST(Extremes, TenThousandPassesEvenOutWithoutLeavingTheRangeOfWhatWas) {
  for (const double t : {0.5, 1.0}) {
    const Surface sphere = make_surface(Builtin::sphere, 500);
    FieldSet before(sphere.mesh().positions.size());
    for (std::uint32_t v = 0; v < before.size(); ++v) {
      before.set(Field::length, v, glm::vec4(v % 7 == 0 ? 0.2f : 0.1f, 0, 0, 0));
      before.set(Field::direction, v, glm::vec4(v % 2 == 0 ? 1 : -1, 0, 0, 0));
    }
    Smooth smooth = flood_smooth(10'000, {Field::direction, Field::length});
    smooth.t = t;
    const FieldSet fields = after(smooth, sphere, before);
    expect_in_range(fields);
    const auto [min, max] = std::minmax_element(fields.length().begin(), fields.length().end());
    EXPECT_GE(*min, 0.1f - 1e-6f);
    EXPECT_LE(*max, 0.2f + 1e-6f);
    EXPECT_LT(*max - *min, 1e-5f);
  }
}

TEST(Extremes, NeighboursWithOppositeNormalsKeepTheirInclinationFor10000Passes) {
  const Surface fold = folded();
  FieldSet before(4);
  for (std::uint32_t v = 0; v < 4; ++v) before.set(Field::direction, v, glm::vec4(v % 2 ? 0.6f : -0.6f, 0.8f, 0, 0));
  Smooth smooth = flood_smooth(10'000, {Field::direction});
  smooth.keep_inclination = true;
  const FieldSet fields = after(smooth, fold, before);
  for (std::uint32_t v = 0; v < 4; ++v) EXPECT_NEAR(glm::length(fields.at(v).direction), 1, 1e-5);
}

TEST(Extremes, BrushesOfNoSizeTouchNothingAndHugeOnesAll) {
  Random random(5);
  for (const RawModel& raw : {testing_models::lone_triangle(random), testing_models::soup(random),
                              testing_models::many_parts(random), testing_models::dented_builtin(random)}) {
    const Surface surface = surface_of(raw);
    const FieldSet before(surface.mesh().positions.size());
    for (const FalloffShape shape : {FalloffShape::volume, FalloffShape::surface}) {
      Paint paint;
      paint.value = 0.5;
      paint.stroke = stroke_through(surface, {glm::dvec3(surface.mesh().positions[0]), glm::dvec3(0)});
      paint.brush = {.radius = 0, .falloff_shape = shape, .strength = 1, .front_faces_only = false};
      EXPECT_TRUE(evaluate(paint, surface, before).delta.empty());
      paint.brush.radius = 1e6;
      const std::size_t touched = evaluate(paint, surface, before).delta.vertices().size();
      const bool everywhere = shape == FalloffShape::volume;
      EXPECT_GE(touched, everywhere ? before.size() : std::size_t{3});
    }
  }
}

TEST(Extremes, ASurfaceBrushStaysOnItsPart) {
  const Surface balls = two_balls();
  const FieldSet before(balls.mesh().positions.size());
  Paint paint;
  paint.value = 0.5;
  paint.stroke = stroke_through(balls, {{-0.2, 0, 0}});
  paint.brush = {.radius = 10, .falloff_shape = FalloffShape::surface, .strength = 1, .front_faces_only = false};
  const std::vector<std::uint32_t> touched = evaluate(paint, balls, before).delta.vertices();
  EXPECT_EQ(touched.size(), before.size() / 2);
  for (const std::uint32_t v : touched) EXPECT_LT(balls.mesh().positions[v].x, 0);
}

}  // namespace
}  // namespace pelage
