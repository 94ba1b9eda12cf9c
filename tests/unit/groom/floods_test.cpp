// Tools that process many vertices at once, against the plain formula for one vertex after the other.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/surface/geodesics.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;

class FloodsTest : public ::testing::Test {
 protected:
  /// Fur that differs from vertex to vertex.
  FieldSet ruffled() const {
    FieldSet fields = first_groom(surface_.mesh(), {.length = 0.03, .inclination = 0.5});
    const Noise noise{.flood = true, .amount = 0.4, .fields = {Field::direction, Field::length}};
    fields.apply(evaluate(noise, surface_, fields).delta);
    return fields;
  }
  glm::dvec3 position(std::uint32_t v) const { return glm::dvec3(surface_.mesh().positions[v]); }

  /// Smoothed lengths, computed by the definition.
  std::vector<double> plainly_smoothed(const Smooth& command, const FieldSet& fields) const {
    std::vector<double> now(fields.length().begin(), fields.length().end());
    const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface_, fields, {});
    for (int pass = 0; pass < command.passes; ++pass) {
      std::vector<double> next = now;
      for (const auto [v, weight] : region) {
        double mean = 0, sum = 0;
        for (const std::uint32_t other : surface_.neighbours(v)) {
          const double inverse = 1 / glm::distance(position(v), position(other));
          mean += inverse * now[other], sum += inverse;
        }
        next[v] = now[v] + command.t * weight * (mean / sum - now[v]);
      }
      now = next;
    }
    return now;
  }

  void expect_smoothed(const Smooth& command) const {
    const FieldSet before = ruffled();
    FieldSet after = before;
    after.apply(evaluate(command, surface_, before).delta);
    const std::vector<double> expected = plainly_smoothed(command, before);
    for (std::uint32_t v = 0; v < before.size(); ++v) ASSERT_NEAR(after.length()[v], expected[v], 1e-8) << v;
  }

  Surface surface_ = make_surface(Builtin::torus, 80'000);  // more vertices than one run of a thread
};

TEST_F(FloodsTest, SmoothFollowsItsFormulaEverywhere) {
  expect_smoothed({.flood = true, .t = 0.7, .passes = 1, .fields = {Field::length}});
  expect_smoothed({.flood = true, .t = 0.7, .passes = 4, .fields = {Field::length}});
}

TEST_F(FloodsTest, SmoothFollowsItsFormulaUnderAStroke) {
  Smooth command{.passes = 1, .fields = {Field::length}};
  command.stroke = stroke_through(surface_, {position(100), position(140)});
  command.brush.radius = 0.03;
  expect_smoothed(command);
  command.passes = 5;
  expect_smoothed(command);
}

TEST_F(FloodsTest, SmoothingDirectionsTurnsThemIntoTheVertexsFrame) {
  const FieldSet before = ruffled();
  FieldSet after = before;
  after.apply(evaluate(Smooth{.flood = true, .brush = {.strength = 1}, .t = 1, .passes = 1}, surface_, before).delta);
  for (std::uint32_t v = 0; v < before.size(); v += 97) {
    glm::dvec3 mean(0);
    double sum = 0;
    for (const std::uint32_t other : surface_.neighbours(v)) {
      const double inverse = 1 / glm::distance(position(v), position(other));
      mean += inverse * lean_of(surface_, before.at(other), other), sum += inverse;
    }
    // Neighbours' frames differ by less than a degree here, so vectors in space may replace transport on the surface.
    EXPECT_LT(glm::distance(lean_of(surface_, after.at(v), v), mean / sum), 0.02) << v;
  }
}

TEST_F(FloodsTest, ManyKeysFollowTheFormulaAsFewDo) {
  const Mesh& mesh = surface_.mesh();
  Random random(4);
  Interpolate command{.sigma = 0.1, .distance = DistanceKind::straight};
  std::vector<std::uint32_t> vertices;
  for (int k = 0; k < 40; ++k) {  // more than one batch of the search
    vertices.push_back(static_cast<std::uint32_t>(random.uniform(0, static_cast<double>(mesh.positions.size()))));
    Key key{.position = mesh.to_model(position(vertices.back()))};
    if (k % 3 != 0) key.length = 0.001 * (k + 1);
    command.keys.push_back(key);
  }
  const FieldSet before = ruffled();
  FieldSet after = before;
  after.apply(evaluate(command, surface_, before).delta);
  for (std::uint32_t v = 0; v < before.size(); v += 501) {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      if (!command.keys[k].length) continue;
      const double distance = glm::distance(position(v), position(vertices[k]));
      const double weight = std::exp(-0.5 * distance * distance / (0.1 * 0.1));
      sum += weight * *command.keys[k].length, weights += weight;
    }
    EXPECT_NEAR(after.length()[v], sum / weights, 2e-6) << v;
  }
}

TEST_F(FloodsTest, GiveTheSameBitsEveryTime) {
  const Mesh& mesh = surface_.mesh();
  const FieldSet fields = ruffled();
  const Key key{mesh.to_model(position(5)), glm::dvec3(0, 1, 0), 0.9, 0.05},
      other{mesh.to_model(position(20'000)), glm::dvec3(1, 0, 0)};
  const std::vector<Command> commands{
      Comb{.flood = true, .direction = glm::dvec3(1, 2, 3)},
      Smooth{.flood = true, .passes = 1, .fields = {Field::direction, Field::length}},
      Smooth{.flood = true, .passes = 3, .fields = {Field::direction, Field::length}},
      Noise{.flood = true, .feature_size = 0.1, .fields = {Field::direction, Field::tip_colour}},
      Unify{.flood = true, .mean = {Field::direction, Field::length}},
      Interpolate{.keys = {key, other}},
      Flow{.curves = {{key.position, other.position}, {key.position, mesh.to_model(position(9'000))}}}};
  for (const Command& command : commands) {
    const FieldDelta first = evaluate(command, surface_, fields).delta;
    EXPECT_FALSE(first.empty()) << op_of(command);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(evaluate(command, surface_, fields).delta, first) << op_of(command);
  }
}

TEST_F(FloodsTest, WritingOnAllCoresGivesWhatOneWriterGives) {
  const FieldSet fields = ruffled();
  const auto value = [&](std::uint32_t v) { return v % 3 == 0 ? double{fields.length()[v]} : v % 1001 ? 0.02 : 50.0; };
  FieldWriter one(fields, Field::length);
  std::size_t held_by_one = 0;
  for (std::uint32_t v = 0; v < fields.size(); ++v) held_by_one += one.put(v, value(v));
  FieldDelta expected, written;
  one.finish(expected);
  const auto count = static_cast<std::uint32_t>(fields.size());
  const std::size_t held =
      write_in_parallel(fields, Field::length, count, written,
                        [&](std::uint32_t v, FieldWriter& writer) { return writer.put(v, value(v)); });
  EXPECT_EQ(written, expected);
  EXPECT_EQ(held, held_by_one);
  EXPECT_GT(held, 0u);
  EXPECT_EQ(write_in_parallel(fields, Field::length, 0, written, [](std::uint32_t, FieldWriter&) { return true; }), 0u);
}

}  // namespace
}  // namespace pelage
