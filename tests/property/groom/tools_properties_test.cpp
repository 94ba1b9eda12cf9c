#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "protocol/base/random.h"
#include "server/groom/evaluate.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::lean_of;
using testing_shapes::make_surface;
using testing_shapes::stroke_through;

const Surface& sphere() {
  static const Surface surface = make_surface(Builtin::sphere, 1000);
  return surface;
}

/// Random commands, with the extremes of every range among their numbers.
class CommandMaker {
 public:
  explicit CommandMaker(std::uint64_t seed) : random_(seed) {}

  Command command() {
    const double kind = random_.uniform();
    if (kind < 0.4) return comb();
    return kind < 0.7 ? Command(blow()) : Command(attract());
  }

  FieldSet fields() {
    FieldSet fields = first_groom(sphere().mesh(), {extreme({0, 1e-6, 10}, 0, 1), extreme({0, 1}, 0, 1)});
    return fields;
  }

 private:
  double extreme(std::vector<double> special, double low, double high) {
    if (random_.uniform() < 0.6) return random_.uniform(low, high);
    return special[static_cast<std::size_t>(random_.uniform(0, static_cast<double>(special.size())))];
  }
  glm::dvec3 point() {
    const double reach = extreme({0, 0.2887, 1e6}, 0, 0.6);
    return reach * glm::dvec3(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
  }
  glm::dvec3 heading() {
    const double length = extreme({1e-300, 1e300}, 0.1, 2);
    return length * glm::dvec3(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(0.1, 1));
  }
  Brush brush() {
    Brush brush;
    brush.radius = extreme({0, 1e6, 1}, 1e-3, 0.5);
    brush.falloff = static_cast<Falloff>(static_cast<int>(random_.uniform(0, 5)));
    brush.strength = extreme({0, 1}, 0, 1);
    brush.spacing = extreme({0.01, 10}, 0.05, 1);
    brush.front_faces_only = random_.uniform() < 0.5;
    brush.invert = random_.uniform() < 0.3;
    return brush;
  }
  std::optional<Stroke> stroke() {
    std::vector<glm::dvec3> points{point()};
    while (random_.uniform() < 0.7) points.push_back(random_.uniform() < 0.2 ? points.back() : point());
    Stroke stroke = stroke_through(sphere(), points);
    for (StrokeSample& sample : stroke.samples) sample.pressure = extreme({0, 1}, 0, 1);
    return stroke;
  }
  Comb comb() {
    Comb comb;
    comb.brush = brush();
    comb.lean = extreme({0, 1}, 0, 1);
    comb.flood = random_.uniform() < 0.2;
    if (comb.flood)
      comb.direction = heading();
    else
      comb.stroke = stroke();
    return comb;
  }
  Blow blow() {
    Blow blow;
    blow.brush = brush();
    blow.source = point();
    blow.direction = heading();
    blow.cone_degrees = extreme({0, 90, 180}, 0, 180);
    blow.softness = extreme({0, 1}, 0, 1);
    blow.strength = extreme({0, 1}, 0, 1);
    blow.lean = extreme({0, 1}, 0, 1);
    if (random_.uniform() < 0.5) blow.stroke = stroke();
    return blow;
  }
  Attract attract() {
    Attract attract;
    attract.brush = brush();
    attract.point = point();
    attract.radius = extreme({0, 1e6}, 0, 1);
    attract.strength = extreme({0, 1}, 0, 1);
    attract.duration = extreme({0, 1e4, 1e-6}, 0, 3);
    attract.threshold = extreme({0, 1e3}, 0, 2);
    attract.max_stretch = extreme({1, 100}, 1, 10);
    if (random_.uniform() < 0.5) attract.stroke = stroke();
    return attract;
  }

  Random random_;
};

/// Commands that resolve refuses (too many dabs) are no subject of evaluate.
bool refused(const Command& command) { return !resolve(command, sphere()).ok(); }

/// Every part rises and changes something; every value is in its field's range.
void expect_sound(const Evaluation& done, const FieldSet& before) {
  FieldSet after = before;
  after.apply(done.delta);
  for (const FieldDelta::Part& part : done.delta.parts) {
    const FieldShape& shape = shape_of(part.field);
    RC_ASSERT(std::is_sorted(part.vertices.begin(), part.vertices.end(), std::less_equal<>()));
    for (const std::uint32_t v : part.vertices) {
      const glm::vec4 value = after.value(part.field, v);
      RC_ASSERT(!(value == before.value(part.field, v)));
      for (int c = 0; c < shape.channels; ++c) RC_ASSERT(value[c] >= shape.least && value[c] <= shape.most);
      const glm::dvec2 direction(value);
      if (part.field == Field::direction) RC_ASSERT(glm::dot(direction, direction) <= 1.0);
    }
  }
}

RC_GTEST_PROP(Tools, GiveFiniteFurAtEveryExtreme, (std::uint64_t seed)) {
  CommandMaker make(seed);
  FieldSet fields = make.fields();
  for (int i = 0; i < 6; ++i) {
    const Command command = make.command();
    if (refused(command)) continue;
    const Evaluation done = evaluate(command, sphere(), fields);
    expect_sound(done, fields);
    fields.apply(done.delta);
  }
}

RC_GTEST_PROP(Tools, GiveTheSameBitsEveryTime, (std::uint64_t seed)) {
  CommandMaker make(seed);
  const FieldSet fields = make.fields();
  const Command command = make.command();
  if (refused(command)) return;
  const Evaluation first = evaluate(command, sphere(), fields), second = evaluate(command, sphere(), fields);
  RC_ASSERT(first.delta == second.delta);
  RC_ASSERT(first.clamped == second.clamped);
}

RC_GTEST_PROP(Tools, DoNothingWithoutStrength, (std::uint64_t seed)) {
  CommandMaker make(seed);
  const FieldSet fields = make.fields();
  Command command = make.command();
  if (auto* comb = std::get_if<Comb>(&command)) comb->brush.strength = 0;
  if (auto* blow = std::get_if<Blow>(&command)) blow->strength = 0;
  if (auto* attract = std::get_if<Attract>(&command)) attract->strength = 0;
  if (refused(command)) return;
  RC_ASSERT(evaluate(command, sphere(), fields).delta.empty());
}

/// One straight stroke sampled at a rate, internal coordinates.
Comb straight_comb(glm::dvec3 from, glm::dvec3 to, int samples, double radius) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= samples; ++i) points.push_back(glm::mix(from, to, static_cast<double>(i) / samples));
  Comb comb;
  comb.stroke = stroke_through(sphere(), points);
  comb.brush.radius = radius;
  return comb;
}

// 30 against 240 samples of one second: the dabs are the same but for rounding, so fields agree to 1e-6 of an
// inclination (a few steps of a 32-bit number).
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

RC_GTEST_PROP(Deltas, UndoAfterDoIsTheIdentity, (std::uint64_t seed)) {
  CommandMaker make(seed);
  FieldSet fields = make.fields();
  const FieldsHash before = fields.hash();
  const Command command = make.command();
  if (refused(command)) return;
  const FieldDelta delta = evaluate(command, sphere(), fields).delta;
  fields.apply(delta);
  RC_ASSERT((fields.hash() == before) == delta.empty());
  fields.apply(delta);
  RC_ASSERT(fields.hash() == before);
}

}  // namespace
}  // namespace pelage
