// What each form of fur does to the strands of the tile.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/colour_space.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {
namespace {

/// A coat of straight, upright strands that are all alike.
Coat plain() {
  Coat coat;
  coat.count = 4000, coat.bend = 0, coat.clump = 0, coat.length_spread = 0, coat.colour_spread = 0;
  return coat;
}

glm::dvec2 tip(const Coat& coat, const Strand& strand) { return strand_offset(coat, strand, 1); }

template <class Value>
double mean_of(const Coat& coat, Value value) {
  double sum = 0;
  const std::vector<Strand> strands = make_strands(coat);
  for (const Strand& strand : strands) sum += value(strand);
  return sum / static_cast<double>(strands.size());
}

/// Mean distance of a tip from the middle of its clump, in sizes.
double spread_of_tips(const Coat& coat) {
  Coat whole = coat;
  whole.wetness = 1;  // without shortening, so that the vectors to the clumps are whole
  const std::vector<Strand> strands = make_strands(coat), centres = make_strands(whole);
  double sum = 0;
  for (std::size_t i = 0; i < strands.size(); ++i) sum += glm::distance(tip(coat, strands[i]), centres[i].clump);
  return sum / static_cast<double>(strands.size());
}

TEST(Forms, StraightStrandsAreStraight) {
  for (const Strand& strand : make_strands(plain())) {
    EXPECT_LT(glm::length(tip(plain(), strand)), 1e-12);
    EXPECT_EQ(strand.length_share, 1);
  }
}

/// Length of a strand that rises by nominal_length, over nominal_length.
double arc_length(const Coat& coat, const Strand& strand) {
  constexpr int steps = 2000;
  double length = 0;
  for (int i = 1; i <= steps; ++i) {
    const glm::dvec2 here = strand_offset(coat, strand, static_cast<double>(i) / steps),
                     before = strand_offset(coat, strand, static_cast<double>(i - 1) / steps);
    length += std::hypot(glm::distance(here, before) / nominal_length, 1.0 / steps);
  }
  return length;
}

TEST(Forms, WindingIsTheLengthAlongAStrand) {
  EXPECT_EQ(winding(plain()), 1);
  for (const auto& [curl, wave, turns] : {std::array{0.02, 0.0, 3.0}, {0.12, 0.0, 8.0}, {0.0, 0.1, 4.0}}) {
    Coat coat = plain();
    coat.count = 100, coat.curl = curl, coat.wave = wave, coat.curl_turns = coat.wave_turns = turns;
    const double mean = mean_of(coat, [&](const Strand& strand) { return arc_length(coat, strand); });
    EXPECT_NEAR(winding(coat) / mean, 1, 0.15) << curl << ' ' << wave;  // curl and wave fade in over the lowest quarter
  }
}

TEST(Forms, WavesLieInOnePlaneWithTheirAmplitude) {
  Coat coat = plain();
  coat.wave = 0.1, coat.wave_turns = 4;
  double sum = 0;
  for (const Strand& strand : make_strands(coat)) {
    const glm::dvec2 direction = glm::normalize(strand.wave);
    double largest = 0;
    int crossings = 0;
    for (int i = 101; i <= 400; ++i) {  // above the first quarter, where the curl has its full amplitude
      const glm::dvec2 here = strand_offset(coat, strand, i / 400.0),
                       before = strand_offset(coat, strand, (i - 1) / 400.0);
      EXPECT_LT(std::abs(here.x * direction.y - here.y * direction.x), 1e-12);
      largest = std::max(largest, glm::length(here));
      crossings += glm::dot(here, direction) * glm::dot(before, direction) < 0;
    }
    EXPECT_NEAR(crossings, 6, 1) << "three waves";
    sum += largest;
  }
  EXPECT_NEAR(sum / coat.count / nominal_length, 0.1, 0.005);
}

TEST(Forms, CurlsAreHelices) {
  Coat coat = plain();
  coat.curl = 0.2;
  for (const Strand& strand : make_strands(coat)) {
    for (const double q : {0.25, 0.6, 1.0}) {
      EXPECT_NEAR(glm::length(strand_offset(coat, strand, q)), 0.2 * nominal_length, 1e-12);
    }
  }
}

TEST(Forms, LocksCurlTogether) {
  Coat coat = plain();
  coat.curl = 0.2, coat.curl_together = 1, coat.clump_size = 0.06;  // four clumps on the tile
  glm::dvec2 sum(0);
  for (const Strand& strand : make_strands(coat)) sum += tip(coat, strand) / (0.2 * nominal_length);
  EXPECT_GT(glm::length(sum) / coat.count, 0.1) << "four phases do not cancel";
  coat.curl_together = 0;
  sum = glm::dvec2(0);
  for (const Strand& strand : make_strands(coat)) sum += tip(coat, strand) / (0.2 * nominal_length);
  EXPECT_LT(glm::length(sum) / coat.count, 0.05);
}

TEST(Forms, MessyStrandsLeanInDirectionsOfTheirOwn) {
  Coat coat = plain();
  coat.mess = 0.8;
  glm::dvec2 sum(0);
  double length = 0;
  for (const Strand& strand : make_strands(coat)) sum += tip(coat, strand), length += glm::length(tip(coat, strand));
  EXPECT_LT(glm::length(sum), 0.05 * length) << "no direction is preferred";
  EXPECT_GT(length / coat.count, 0.25 * nominal_length);
  EXPECT_LT(mean_of(coat, [](const Strand& s) { return s.length_share; }), 0.95)
      << "a strand that leans reaches less high";
}

TEST(Forms, LocksGatherInsideClumps) {
  Coat coat = plain();
  coat.fine_clump = 1;
  const auto to_lock = [&](const Strand& s) { return glm::distance(tip(coat, s), s.fine_clump); };
  EXPECT_LT(mean_of(coat, to_lock), 1e-12);
  coat.clump = 0.8, coat.count = 1500, coat.wetness = 1;
  const std::vector<Strand> strands = make_strands(coat);
  std::size_t shared = 0;
  for (std::size_t i = 0; i < strands.size(); ++i) {  // strands of one lock belong to one clump
    for (std::size_t k = i + 1; k < strands.size(); ++k) {
      if (glm::distance(strands[i].root + strands[i].fine_clump, strands[k].root + strands[k].fine_clump) > 1e-9)
        continue;
      ++shared;
      EXPECT_LT(glm::distance(strands[i].root + strands[i].clump, strands[k].root + strands[k].clump), 1e-9);
    }
  }
  EXPECT_GT(shared, 500u);
  coat.wetness = 0;
  Coat coarse = coat;
  coarse.fine_clump = 0;
  EXPECT_LT(spread_of_tips(coat), 1.05 * spread_of_tips(coarse)) << "locks do not loosen the clumps";
}

TEST(Forms, LodgedPatchesLieAndTheRestStands) {
  Coat coat = plain();
  coat.lodge = 1, coat.count = 1500;
  std::size_t lying = 0, standing = 0, alike = 0;
  const std::vector<Strand> strands = make_strands(coat);
  for (const Strand& strand : strands) {
    const double sine = glm::length(strand.heading) / nominal_length;
    lying += sine > 0.8, standing += sine < 0.1;
    EXPECT_NEAR(strand.length_share, std::sqrt(1 - sine * sine), 1e-9) << "strands keep their length";
    for (const Strand& other : strands) {
      if (&other == &strand || sine < 0.8 || glm::distance(other.root, strand.root) > 0.003) continue;
      alike += glm::dot(glm::normalize(other.heading + 1e-12), glm::normalize(strand.heading)) > 0.99;
    }
  }
  EXPECT_GT(lying, strands.size() / 8);
  EXPECT_GT(standing, strands.size() / 5);
  EXPECT_GT(alike, lying) << "neighbours lie in the same direction";
}

TEST(Forms, UndercoatAndOvercoatAreTwoLengths) {
  Coat coat = plain();
  coat.length_spread = 0.2;
  coat.undercoat = {
      .share = 0.6, .length = 0.5, .width = 0.4, .lightness = 0.5, .tint = 1, .colour = {0.2f, 0.3f, 0.4f}};
  int under = 0, between = 0;
  for (const Strand& strand : make_strands(coat)) {
    between += strand.length_share > 0.5 && strand.length_share < 0.8;
    if (strand.length_share > 0.5) {
      EXPECT_EQ(strand.width, 1);
      continue;
    }
    ++under;
    EXPECT_EQ(strand.width, 0.4);
    EXPECT_LT(glm::distance(strand_colour(coat, strand, 0.3), glm::vec3(0.1f, 0.15f, 0.2f)), 1e-6f);
  }
  EXPECT_EQ(between, 0);
  EXPECT_NEAR(under / double(coat.count), 0.6, 0.03);
}

TEST(Forms, TickingHasItsShareAndColour) {
  Coat coat = plain();
  coat.ticking = {.share = 0.1, .colour = {0.9f, 0.8f, 0.7f}};
  const double ticked = mean_of(coat, [&](const Strand& strand) {
    return strand_colour(coat, strand, 0) == glm::vec3(0.9f, 0.8f, 0.7f) && strand_colour(coat, strand, 1).r == 0.9f;
  });
  EXPECT_NEAR(ticked, 0.1, 0.015);
}

TEST(Forms, WaterGathersDarkensAndShines) {
  Coat dry;
  dry.bend = 0;
  Coat wet = dry;
  wet.wetness = 1;
  EXPECT_LT(spread_of_tips(wet), 0.5 * spread_of_tips(dry));
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(ramp_colour(wet, 1)[k], std::pow(double(ramp_colour(dry, 1)[k]), wet_absorption(wet.wetness)), 1e-5);
    EXPECT_LT(ramp_colour(wet, 1)[k], 0.75f * ramp_colour(dry, 1)[k]);
  }
  EXPECT_EQ(wet_shine(dry.wetness), 1);
  EXPECT_EQ(wet_sharpness(dry.wetness), 1);
  EXPECT_EQ(wet_shine(wet.wetness), 2);
  EXPECT_EQ(wet_sharpness(wet.wetness), 3);
}

TEST(Forms, OneFormLeavesTheOthersAsTheyWere) {
  Coat changed;
  changed.wave = 0.1, changed.undercoat.share = 0.5, changed.ticking.share = 0.2;
  const std::vector<Strand> before = make_strands(Coat()), after = make_strands(changed);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].root, after[i].root);
    EXPECT_EQ(before[i].bow, after[i].bow);
    EXPECT_EQ(before[i].lightness, after[i].lightness);
    EXPECT_EQ(before[i].number, after[i].number);
  }
}

TEST(Forms, WarmthTurnsHuesAndKeepsTheLightOfGrey) {
  Coat coat;
  coat.colour_spread = 0, coat.warmth_spread = 1;
  const std::vector<Strand> before = make_strands(Coat()), strands = make_strands(coat);
  double min_ratio = 1, max_ratio = 1;
  for (std::size_t i = 0; i < strands.size(); ++i) {
    const glm::vec3 tint = strand_tint(strands[i]);
    EXPECT_NEAR(luminance(tint), 1, 1e-5);
    min_ratio = std::min(min_ratio, double{tint.r / tint.b}), max_ratio = std::max(max_ratio, double{tint.r / tint.b});
    EXPECT_EQ(strands[i].number, before[i].number);
  }
  EXPECT_NEAR(min_ratio, 0.5, 1e-3);
  EXPECT_NEAR(max_ratio, 2, 4e-3);
  EXPECT_EQ(strand_tint(before[0]), glm::vec3(static_cast<float>(before[0].lightness)));
}

TEST(Forms, RootsStayAndLengthsAreShares) {
  Coat coat;
  coat.wave = 0.5, coat.curl = 0.5, coat.mess = 1, coat.lodge = 1, coat.fine_clump = 1, coat.clump = 1,
  coat.wetness = 1;
  coat.length_spread = 1, coat.undercoat = {.share = 0.5, .length = 0.02};
  for (const Strand& strand : make_strands(coat)) {
    EXPECT_LT(glm::length(strand_offset(coat, strand, 0)), 1e-12);
    EXPECT_TRUE(strand.length_share > 0 && strand.length_share <= 1);
    EXPECT_TRUE(std::isfinite(tip(coat, strand).x) && std::isfinite(tip(coat, strand).y));
  }
}

TEST(Forms, PatternsNeedNoNewStrands) {
  Coat coat;
  coat.pattern.kind = PatternKind::stripes, coat.variation.hue = 0.5, coat.root_share = 0.9;
  EXPECT_TRUE(same_strands(coat, Coat()));
  coat.wetness = 0.1;
  EXPECT_FALSE(same_strands(coat, Coat()));
}

TEST(Slices, BakeEveryForm) {
  Coat coat;
  coat.count = 3000, coat.wave = 0.1, coat.mess = 0.5, coat.lodge = 0.5, coat.fine_clump = 0.5, coat.wetness = 0.5;
  coat.undercoat.share = 0.5, coat.ticking = {.share = 0.1, .colour = {1, 0, 0}};
  const Slices slices = bake_slices(coat), plain_slices = bake_slices(Coat{.count = 3000});
  EXPECT_NE(slices.levels[0].shape, plain_slices.levels[0].shape);
  const auto max_red = [](const Slices& s) {  // how far red exceeds green in any texel
    int max = 0;
    const auto& texels = s.levels[0].colour;
    for (std::size_t i = 0; i < texels.size(); i += 4) max = std::max(max, texels[i] - texels[i + 1]);
    return max;
  };
  EXPECT_GT(max_red(slices), 200);
  EXPECT_LT(max_red(plain_slices), 100);
}

}  // namespace
}  // namespace pelage
