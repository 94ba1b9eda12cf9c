// The colours of grown strands against the formulas of the shaders.
#include <gtest/gtest.h>

#include <cmath>

#include "base/colour_space.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/image/float_image.h"
#include "renderer/pattern/pattern.h"
#include "renderer/strands/tile_strands.h"
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

TEST(GrowColour, MeansLeaveTheCoatTheColourThatItHas) {
  Coat coat;
  coat.count = 3000, coat.ticking.share = 0.3, coat.ticking.colour = {0.9f, 0.8f, 0.7f};
  coat.ramp = {{0, glm::vec3(0.05f)}, {1, {0.5f, 0.2f, 0.1f}}};
  coat.pattern.kind = PatternKind::spots;
  const StrandSet set = FurPatch(0.2, 4).grow({coat});
  ASSERT_EQ(set.to_mean.size(), set.count());
  const int seen = TileStrands(coat, set.segments).seen_knot();
  glm::dvec3 to_mean(0), own(0);
  for (std::uint32_t i = 0; i < set.count(); ++i) {
    const glm::vec3 colour = colour_of(set, i, seen), factor = unpack_colour(set.to_mean[i]);
    own += colour, to_mean += factor * colour;
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(to_mean[k], own[k], 0.05 * own[k]) << "what all show stays";
}

TEST(GrowColour, MeanStrandsVaryWithTheirPosition) {
  Coat coat;
  coat.count = 3000, coat.ticking.share = 0.3, coat.ticking.colour = {0.9f, 0.8f, 0.7f};
  coat.ramp = {{0, {0.2f, 0.15f, 0.1f}}, {1, {0.2f, 0.15f, 0.1f}}};
  const StrandSet set = FurPatch(0.2, 4).grow({coat});
  const TileStrands tile(coat, set.segments);
  const auto shown_by = [&](std::uint32_t i) {
    return unpack_colour(set.to_mean[i]) * colour_of(set, i, tile.seen_knot());
  };
  for (std::uint32_t i = 0; i < set.count(); ++i) {
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(shown_by(i)[k], shown_by(0)[k], 0.1f * shown_by(0)[k]) << i;
  }
}

TEST(GrowColour, ModelGivesTheHue) {
  // A red and a blue texel; half-grey vertex colours.
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

/// Colour of a strand with its root at a point, which would be `base` without a pattern.
glm::vec3 pattern_colour(const PatternBlock& block, glm::vec3 position, glm::vec3 normal, glm::vec3 base) {
  const glm::vec4 varied = pattern_variation(block, position);
  return with_weights(block, pattern_weights(block, position, normal), base) *
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
    const glm::vec3 expected = pattern_colour(block, knot(set, i, 0).position, {0, 0, 1}, coat.ramp[0].colour);
    expect_colour(colour_of(set, i, 3), expected);
    darkest = std::min(darkest, expected.r), lightest = std::max(lightest, expected.r);
  }
  EXPECT_LT(darkest, 0.3f * lightest);
}

TEST(GrowColour, PaintLiesOverIt) {
  FurPatch patch(0.12);
  const std::vector<glm::vec4> root(4, glm::vec4(1, 0, 0, 1)), tip_paint(4, glm::vec4(0, 0, 1, 0.5f));
  patch.paint.root_colour = root, patch.paint.tip_colour = tip_paint;
  const Coat coat = plain_coat(50);  // all strands are alike, so that none is lighter than the mean
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
