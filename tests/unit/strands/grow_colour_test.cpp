// The colours of grown strands beside the formulas of the shaders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "protocol/base/colour_space.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/image/float_image.h"
#include "renderer/pattern/pattern.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

glm::vec3 colour_of(const StrandSet& set, std::size_t strand, int k) {
  return unpack_colour(set.colours[strand * static_cast<std::size_t>(set.segments + 1) + static_cast<std::size_t>(k)]);
}

void expect_colour(glm::vec3 colour, glm::vec3 expected) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], expected[k], 0.002f * std::sqrt(expected[k]) + 1e-5f);
}

TEST(GrowColour, IsTheStrandsOwn) {
  Coat coat;
  coat.count = 300, coat.undercoat.share = 0.3, coat.undercoat.tint = 0.5, coat.ticking.share = 0.2, coat.wetness = 0.4;
  const StrandSet set = FurPatch(0.12).grow({coat});
  for (const Strand& strand : make_strands(coat)) {
    for (std::size_t i = 0; i < set.count(); ++i) {
      if (set.roots[i].number != static_cast<float>(strand.number)) continue;
      for (int k = 0; k <= set.segments; ++k)
        expect_colour(colour_of(set, i, k), strand_colour(coat, strand, static_cast<double>(k) / set.segments));
    }
  }
}

TEST(GrowColour, GroupsHaveTheMeanOfStrandsThatLieTogether) {
  Coat coat;
  coat.count = 4000, coat.ticking.share = 0.3;
  const StrandSet set = FurPatch(0.2, 4).grow({coat});
  const std::size_t knots = static_cast<std::size_t>(set.segments) + 1;
  ASSERT_EQ(set.groups(), (set.count() + 7) / 8);
  std::vector<glm::dvec3> sums(set.groups()), roots(set.groups());
  std::vector<double> weights(set.groups());
  std::vector<int> members(set.groups());
  for (std::uint32_t i = 0; i < set.count(); ++i) {
    const std::uint32_t group = set.group_of(i);
    ASSERT_LT(group, set.groups());
    const double weight = set.points[i * knots + 3].radius;
    sums[group] += weight * glm::dvec3(colour_of(set, i, 3)), weights[group] += weight, ++members[group];
    roots[group] += glm::dvec3(set.points[i * knots].place) / 8.0;
  }
  double apart = 0;
  int whole = 0;
  for (std::uint32_t g = 0; g < set.groups(); ++g) {
    expect_colour(unpack_colour(set.group_colours[g * knots + 3]), glm::vec3(sums[g] / weights[g]));
    if (members[g] != 8) continue;  // the last on the curve
    apart += glm::distance(roots[g], glm::dvec3(set.points[g * knots].place)), ++whole;
  }
  EXPECT_GE(whole, static_cast<int>(set.groups()) - 1);
  EXPECT_LT(apart / whole, 0.2 * std::sqrt(8.0 / static_cast<double>(set.count())));
}

TEST(GrowColour, ModelGivesTheHue) {
  // Two texels: a red and a blue one; half grey vertex colours.
  const std::vector<std::uint8_t> pixels{255, 0, 0, 255, 0, 0, 128, 255};
  FurPatch patch(0.12);
  patch.images = {{2, 1, pixels}};
  for (auto& corners : patch.corners) {
    for (FurCorner& corner : corners)
      corner.image = 0, corner.colour = glm::vec3(0.5f), corner.image_uv = {0.25f, 0.5f};
  }
  GrowRecipe recipe{plain_coat(50), true};
  recipe.coat.ramp = {{0, glm::vec3(0.1f)}, {1, glm::vec3(0.4f)}};
  const auto at = [&](float u) {
    for (auto& corners : patch.corners) {
      for (FurCorner& corner : corners) corner.image_uv.x = u;
    }
    return patch.grow(recipe);
  };
  const float blue = static_cast<float>(linear_from_srgb(128 / 255.0));
  expect_colour(colour_of(at(0.25f), 0, 0), glm::vec3(0.5f, 0, 0) * (0.36f + 0.84f * 0.25f));
  expect_colour(colour_of(at(0.25f), 0, 6), glm::vec3(0.5f, 0, 0) * 1.2f);
  expect_colour(colour_of(at(-0.25f), 0, 6), glm::vec3(0, 0, 0.5f * blue) * 1.2f);
  expect_colour(colour_of(at(7.5f), 0, 6), glm::vec3(0.25f, 0, 0.25f * blue) * 1.2f);
  recipe.model_colours = false;
  expect_colour(colour_of(at(0.25f), 0, 6), glm::vec3(0.4f));
}

TEST(GrowColour, PicturesHaveVUp) {
  const std::vector<std::uint8_t> pixels{255, 255, 255, 255, 0, 0, 0, 255};  // white above black
  FurPatch patch(0.12);
  patch.images = {{1, 2, pixels}};
  for (auto& corners : patch.corners) {
    for (FurCorner& corner : corners) corner.image = 0, corner.image_uv = {0.5f, 0.75f};
  }
  expect_colour(colour_of(patch.grow({plain_coat(50), true}), 0, 0), glm::vec3(1.2f));
}

/// The colour of a strand whose root stands there and that would be `base` without a pattern.
glm::vec3 pattern_colour(const PatternBlock& block, glm::vec3 place, glm::vec3 normal, glm::vec3 base) {
  const glm::vec4 varied = pattern_variation(block, place);
  return with_weights(block, pattern_weights(block, place, normal), base) *
         (varied.z * glm::vec3(1 + varied.w, 1, 1 - varied.w));
}

TEST(GrowColour, PatternIsThatOfTheRoot) {
  Coat coat = plain_coat(400);
  coat.pattern.kind = PatternKind::spots, coat.pattern.belly = 0.5;
  coat.variation.lightness = 0.5, coat.variation.hue = 0.5;
  const StrandSet set = FurPatch(0.4, 4).grow({coat});
  const PatternBlock block = make_pattern_block(coat);
  float darkest = 9, lightest = 0;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::vec3 expected = pattern_colour(block, knot(set, i, 0).place, {0, 0, 1}, coat.ramp[0].colour);
    expect_colour(colour_of(set, i, 3), expected);
    darkest = std::min(darkest, expected.r), lightest = std::max(lightest, expected.r);
  }
  EXPECT_LT(darkest, 0.3f * lightest);
}

TEST(GrowColour, PaintLiesOverIt) {
  FurPatch patch(0.12);
  const std::vector<glm::vec4> root(4, glm::vec4(1, 0, 0, 1)), tip_paint(4, glm::vec4(0, 0, 1, 0.5f));
  patch.paint.root_colour = root, patch.paint.tip_colour = tip_paint;
  const Coat coat = plain_coat(50);  // all strands alike, so that none is lighter than the mean
  const StrandSet set = patch.grow({coat});
  expect_colour(colour_of(set, 0, 0), {1, 0, 0});
  expect_colour(colour_of(set, 0, 6), coat.ramp[0].colour * 0.5f + glm::vec3(0, 0, 0.5f));
  expect_colour(colour_of(set, 0, 3), coat.ramp[0].colour * 0.25f + glm::vec3(0.5f, 0, 0.25f));
}

TEST(GrowColour, PaintLeavesStrandsTheirLightness) {
  FurPatch patch(0.12);
  const std::vector<glm::vec4> root(4, glm::vec4(0.5f, 0.5f, 0.5f, 1));
  patch.paint.root_colour = patch.paint.tip_colour = root;
  Coat coat = plain_coat(500);
  coat.colour_spread = 0.3;
  const std::vector<Strand> strands = make_strands(coat);
  double mean = 0;
  for (const Strand& strand : strands) mean += strand.lightness / 500;
  const StrandSet set = patch.grow({coat});
  for (std::size_t i = 0; i < set.count(); ++i) {
    for (const Strand& strand : strands) {
      if (static_cast<float>(strand.number) != set.roots[i].number) continue;
      expect_colour(colour_of(set, i, 0), glm::vec3(0.5 * glm::clamp(strand.lightness / mean, 0.5, 1.6)));
    }
  }
}

TEST(GrowColour, PaintedWaterDarkens) {
  FurPatch patch(0.12);
  const std::vector<float> wet(4, 0.5f);
  patch.paint.wetness = wet;
  Coat coat = plain_coat(50);
  coat.wetness = 0.25;
  const glm::vec3 own = ramp_colour(coat, 0);
  expect_colour(colour_of(patch.grow({coat}), 0, 0), glm::pow(own, glm::vec3((1 + 0.8f * 0.75f) / (1 + 0.8f * 0.25f))));
}

}  // namespace
}  // namespace pelage
