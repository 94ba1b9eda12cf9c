#include "renderer/pattern/pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/random.h"
#include "renderer/pattern/cells.h"

namespace pelage {
namespace {

constexpr std::array marked_kinds{PatternKind::stripes, PatternKind::spots, PatternKind::rosettes, PatternKind::tabby,
                                  PatternKind::patches};

Coat with(const Pattern& pattern) {
  Coat coat;
  coat.ramp = {{0, glm::vec3(0.6f)}};
  coat.pattern = pattern;
  return coat;
}

/// Visits evenly distributed points on a sphere of radius .4, with their normals.
void for_each_position(int count, const std::function<void(glm::vec3, glm::vec3)>& visit) {
  Random random(5);
  for (int i = 0; i < count; ++i) {
    const double up = random.uniform(-1, 1), turn = random.uniform(0, 6.283185307179586), out = std::sqrt(1 - up * up);
    const glm::vec3 normal(out * std::cos(turn), up, out * std::sin(turn));
    visit(0.4f * normal, normal);
  }
}

/// Coverage at a point by the marking, and by the inner colour.
glm::vec2 pattern_marks(PatternBlock block, glm::vec3 position, glm::vec3 normal) {
  block.amounts.x = block.amounts.y = 1, block.amounts.w = 0;
  const glm::vec3 weights = pattern_weights(block, position, normal);
  return {weights.z, weights.y};
}

/// Colour of a strand with its root at a point, which would be `base` without a pattern.
glm::vec3 pattern_colour(const PatternBlock& block, glm::vec3 position, glm::vec3 normal, glm::vec3 base) {
  const glm::vec4 varied = pattern_variation(block, position);
  return with_weights(block, pattern_weights(block, position, normal), base) *
         (varied.z * glm::vec3(1 + varied.w, 1, 1 - varied.w));
}

/// Mean coverage over a sphere.
glm::dvec2 mean_marks(const Pattern& pattern) {
  const PatternBlock block = make_pattern_block(with(pattern));
  glm::dvec2 sum(0);
  for_each_position(
      20000, [&](glm::vec3 position, glm::vec3 normal) { sum += glm::dvec2(pattern_marks(block, position, normal)); });
  return sum / 20000.0;
}

TEST(Noise, HasTheMomentsThatItSays) {
  double sum = 0, square = 0, largest = 0;
  Random random(1);
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 position(random.uniform(-90, 90), random.uniform(-90, 90), random.uniform(-90, 90));
    const double value = gradient_noise(position, 3, 7);
    sum += value, square += value * value, largest = std::max(largest, std::abs(value));
  }
  EXPECT_NEAR(sum / count, 0, 0.005);
  EXPECT_NEAR(std::sqrt(square / count), 0.19, 0.01);
  EXPECT_LT(largest, 1.2);
}

TEST(Noise, IsContinuousAcrossCells) {
  for (int i = -3; i < 3; ++i) {
    const auto at = [&](float x) { return glm::vec3(x, 0.3f + float(i), -1.7f); };
    EXPECT_NEAR(gradient_noise(at(float(i) - 1e-5f), 0, 1), gradient_noise(at(float(i) + 1e-5f), 0, 1), 1e-4);
    const glm::vec3 normal(0, 0, 1);
    for (float x = -2; x < 2; x += 1e-3f) {
      EXPECT_NEAR(cell_distance(at(x), normal, 0, 1), cell_distance(at(x + 1e-4f), normal, 0, 1), 2e-3) << x;
    }
  }
}

TEST(Noise, StreamsAndSeedsDiffer) {
  const auto x = [](glm::ivec3 cell, std::uint32_t stream, std::uint32_t seed) {
    return numbers_of(corner_cells(cell), stream, seed).x;
  };
  EXPECT_NE(x({1, 2, 3}, 0, 1), x({1, 2, 3}, 1, 1));
  EXPECT_NE(x({1, 2, 3}, 0, 1), x({1, 2, 3}, 0, 2));
  EXPECT_NE(x({1, 2, 3}, 0, 1), x({-1, 2, 3}, 0, 1));
  EXPECT_EQ(x({1, 2, 3}, 0, 1)[1], x({2, 2, 3}, 0, 1)[0]);  // both are the same cell
}

TEST(Pattern, NoneIsTheBaseItself) {
  const PatternBlock block = make_pattern_block(Coat());
  EXPECT_FALSE(has_pattern(Coat()));
  const glm::vec3 base(0.3f, 0.2f, 0.1f);
  EXPECT_EQ(pattern_colour(block, {0.1f, 0.2f, 0.3f}, {0, 1, 0}, base), base);
  EXPECT_EQ(pattern_length(block, {0.1f, 0.2f, 0.3f}), 1);
  EXPECT_EQ(pattern_lean(block, {0.1f, 0.2f, 0.3f}), 0);
}

TEST(Pattern, CoverageIsTheShareThatIsMarked) {
  for (const double coverage : {0.15, 0.3, 0.5}) {
    EXPECT_NEAR(mean_marks({.kind = PatternKind::stripes, .coverage = coverage, .legs = 0}).x, coverage, 0.06);
    EXPECT_NEAR(mean_marks({.kind = PatternKind::spots, .coverage = coverage}).x, coverage, 0.08);
    EXPECT_NEAR(mean_marks({.kind = PatternKind::patches, .coverage = coverage}).x, coverage, 0.08);
  }
}

TEST(Pattern, NoCoverageMarksNothingAndAllMarksAll) {
  for (const PatternKind kind : marked_kinds) {
    EXPECT_LT(mean_marks({.kind = kind, .coverage = 0}).x, 0.01) << int(kind);
  }
  EXPECT_GT(mean_marks({.kind = PatternKind::stripes, .coverage = 1}).x, 0.99);
  EXPECT_GT(mean_marks({.kind = PatternKind::patches, .coverage = 1}).x, 0.99);
}

TEST(Pattern, StripesFollowEachOtherAtTheirScale) {
  const Pattern pattern{.kind = PatternKind::stripes, .scale = 0.05, .softness = 0, .warp = 0, .legs = 0};
  const PatternBlock block = make_pattern_block(with(pattern));
  const auto marked = [&](float x, float z) { return pattern_marks(block, {x, 0.2f, z}, {0, 1, 0}).x > 0.5f; };
  int edges = 0;
  for (int i = 0; i < 5000; ++i) edges += marked(0, float(i) * 1e-4f) != marked(0, float(i + 1) * 1e-4f);
  EXPECT_EQ(edges, 20);  // two edges for each of the ten stripes in half a size
  for (int i = 0; i < 100; ++i) EXPECT_EQ(marked(0, 0.01f * float(i)), marked(0.3f, 0.01f * float(i)));
}

TEST(Pattern, StripesTurnToRingsOnLegs) {
  const auto changes_down_a_leg = [](double legs) {
    const Pattern pattern{.kind = PatternKind::stripes, .scale = 0.05, .warp = 0, .legs = legs};
    const PatternBlock block = make_pattern_block(with(pattern));
    int changes = 0;
    for (float y = -0.4f; y < -0.15f; y += 0.001f) {
      changes += std::abs(pattern_marks(block, {0.1f, y, 0.2f}, {1, 0, 0}).x -
                          pattern_marks(block, {0.1f, y + 0.001f, 0.2f}, {1, 0, 0}).x) > 0.01f;
    }
    return changes;
  };
  EXPECT_EQ(changes_down_a_leg(0), 0);
  EXPECT_GT(changes_down_a_leg(1), 10);
}

TEST(Pattern, RosettesHaveALightMiddle) {
  const glm::dvec2 rosettes = mean_marks({.kind = PatternKind::rosettes, .legs = 0});
  EXPECT_GT(rosettes.x, 0.08);
  EXPECT_GT(rosettes.y, 1.5 * rosettes.x) << "the ring covers less than the disc";
  const PatternBlock block = make_pattern_block(with({.kind = PatternKind::rosettes, .legs = 1}));
  for_each_position(5000, [&](glm::vec3 position, glm::vec3 normal) {
    if (position.y > -0.2f) return;
    const glm::vec2 marks = pattern_marks(block, position, normal);
    EXPECT_NEAR(marks.x, marks.y, 1e-6f) << "filled on legs";
  });
}

TEST(Pattern, TabbyHasALineAlongTheSpine) {
  const Pattern pattern{.kind = PatternKind::tabby, .coverage = 0.4};
  const PatternBlock block = make_pattern_block(with(pattern));
  for (float z = -0.4f; z < 0.4f; z += 0.01f) EXPECT_GT(pattern_marks(block, {0, 0.2f, z}, {0, 1, 0}).x, 0.95f) << z;
  float min = 1;
  for (float z = -0.4f; z < 0.4f; z += 0.01f) {
    min = std::min(min, pattern_marks(block, {0.1f, 0.1f, z}, {1, 0, 0}).x);
  }
  EXPECT_LT(min, 0.05f) << "and none along the flank";
}

TEST(Pattern, TheUndersideTurnsPaleAndLosesItsMarkings) {
  const Pattern pattern{.kind = PatternKind::stripes, .belly = 1};
  const PatternBlock block = make_pattern_block(with(pattern));
  for (float z = -0.3f; z < 0.3f; z += 0.01f) {
    const glm::vec3 below = pattern_colour(block, {0, -0.1f, z}, {0, -1, 0}, glm::vec3(0.6f));
    EXPECT_NEAR(below.r, 1.2f * 0.75f, 0.02f) << "belly_colour in the lightness of the ramp's brightest";
  }
  const Pattern shaded{.kind = PatternKind::countershading, .softness = 0.1};
  const PatternBlock counter = make_pattern_block(with(shaded));
  EXPECT_GT(pattern_colour(counter, {0, -0.2f, 0}, {0, -1, 0}, glm::vec3(0.6f)).r, 0.85f);
  EXPECT_EQ(pattern_colour(counter, {0, 0.2f, 0}, {0, 1, 0}, glm::vec3(0.6f)), glm::vec3(0.6f));
}

TEST(Pattern, MarkingsGetLighterAlongTheStrand) {
  const Pattern pattern{.kind = PatternKind::stripes, .coverage = 1, .warp = 0, .colour = glm::vec3(0.1f)};
  const PatternBlock block = make_pattern_block(with(pattern));
  const auto red = [&](float base) { return pattern_colour(block, {0, 0.1f, 0.03f}, {0, 1, 0}, glm::vec3(base)).r; };
  EXPECT_NEAR(red(0.6f), 0.1f * 1.2f, 1e-4f);
  EXPECT_NEAR(red(0.3f), 0.1f * 0.78f, 1e-4f);
}

TEST(Pattern, WaterDarkensMarkings) {
  Coat coat = with({.kind = PatternKind::stripes, .coverage = 1, .colour = glm::vec3(0.1f)});
  coat.wetness = 1;
  EXPECT_NEAR(make_pattern_block(coat).colour.r, std::pow(0.1, 1.8), 1e-5);
}

TEST(Variation, StaysInItsRangeAndChangesSlowly) {
  Coat coat;
  coat.variation = {.lightness = 1, .hue = 1, .length = 1, .lean = 1, .size = 0.2};
  EXPECT_TRUE(has_pattern(coat));
  const PatternBlock block = make_pattern_block(coat);
  float min = 2, max = 0, steepest = 0;
  for_each_position(20000, [&](glm::vec3 position, glm::vec3) {
    const float length = pattern_length(block, position), lean = pattern_lean(block, position);
    min = std::min(min, length), max = std::max(max, length);
    EXPECT_TRUE(lean >= -1 && lean <= 1);
    steepest = std::max(steepest, std::abs(pattern_length(block, position + glm::vec3(0.002f, 0, 0)) - length));
    const glm::vec3 colour = pattern_colour(block, position, {0, 1, 0}, glm::vec3(0.5f));
    EXPECT_TRUE(colour.g >= 0.25f && colour.g <= 1.0f);
    EXPECT_TRUE(colour.r / colour.g > 0.66f && colour.r / colour.g < 1.34f);
  });
  EXPECT_LT(min, 0.2f);
  EXPECT_GT(max, 1.8f);
  EXPECT_LT(steepest, 0.1f) << "over a hundredth of a swell";
}

TEST(Pattern, ExtremesAreFinite) {
  for (const PatternKind kind : marked_kinds) {
    for (const double scale : {0.005, 2.0}) {
      for (const double edge : {0.0, 1.0}) {
        Coat coat =
            with({.kind = kind, .scale = scale, .coverage = edge, .softness = edge, .warp = 2 * edge, .belly = edge});
        coat.ramp = {{0, glm::vec3(0)}};
        const PatternBlock block = make_pattern_block(coat);
        for_each_position(500, [&](glm::vec3 position, glm::vec3 normal) {
          const glm::vec3 colour = pattern_colour(block, position, normal, glm::vec3(0));
          EXPECT_TRUE(glm::all(glm::greaterThanEqual(colour, glm::vec3(0))));
          EXPECT_TRUE(glm::all(glm::lessThan(colour, glm::vec3(4)))) << int(kind);
        });
      }
    }
  }
}

}  // namespace
}  // namespace pelage
