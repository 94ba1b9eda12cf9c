#include "renderer/coat/slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>

#include "renderer/coat/strand_cover.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {
namespace {

Coat thin_coat() {
  Coat coat;
  coat.count = 1500;
  return coat;
}

double depth_at(const SliceLevel& level, int x, int y, int slice) {
  const auto wrapped = [&](int i) { return ((i % level.texels) + level.texels) % level.texels; };
  const std::size_t texel = (static_cast<std::size_t>(slice) * level.texels + wrapped(y)) * level.texels + wrapped(x);
  return level.shape[4 * texel + 3] / 255.0 * stored_depth;
}

/// Bilinear lookup as the GPU does it; texel centres are at whole numbers.
double filtered_depth(const SliceLevel& level, double x, double y, int slice) {
  const int left = static_cast<int>(std::floor(x)), low = static_cast<int>(std::floor(y));
  const auto row = [&](int at) {
    return std::lerp(depth_at(level, left, at, slice), depth_at(level, left + 1, at, slice), x - left);
  };
  return std::lerp(row(low), row(low + 1), y - low);
}

/// Interpolates the depth scale between the known angles, as slab.glsl does.
double scale_at(const SliceLevel& level, double sine) {
  const auto [along, at60, at30, at75] = level.depth_scale;
  const double sine60 = std::sqrt(0.75), sine75 = std::sin(75 * std::numbers::pi / 180);
  if (sine < 0.5) return std::lerp(along, at30, 2 * sine);
  if (sine < sine60) return std::lerp(at30, at60, (sine - 0.5) / (sine60 - 0.5));
  return std::lerp(at60, at75, std::min((sine - sine60) / (sine75 - sine60), 1.0));
}

/// Mean transmittance of the slices from `lowest` up, for rays at that angle to the normal (degrees). Reads the stored
/// bytes and marches as slab.glsl does.
double transmittance(const Coat& coat, const SliceLevel& level, double angle, int lowest = 0) {
  constexpr int parts = 4;
  const double slant = 1 / std::cos(angle * std::numbers::pi / 180), across = std::sqrt(slant * slant - 1);
  const double scale = scale_at(level, across / slant);
  const double shift = across * nominal_length / slice_count / coat.tile * level.texels;
  const int stride = std::max(1, level.texels / 128);
  double sum = 0;
  int count = 0;
  for (int y = 0; y < level.texels; y += stride) {
    for (int x = 0; x < level.texels; x += stride) {
      const double across_texel = std::fmod(0.618034 * count, 1.0), up_texel = std::fmod(0.414214 * count, 1.0);
      double depth = 0;
      for (int i = lowest * parts; i < slice_count * parts; ++i)
        depth += filtered_depth(level, x + across_texel + shift * (i + 0.5) / parts, y + up_texel, i / parts);
      sum += std::exp(-depth / parts * scale * slant), ++count;
    }
  }
  return sum / count;
}

/// A coat of straight strands of one width at random positions.
Coat plain_coat() {
  Coat coat;
  coat.count = 3000, coat.width_root = coat.width_tip = 0.0008;
  coat.bend = coat.clump = coat.length_spread = 0;
  return coat;
}

TEST(Strands, DependOnTheSeedAlone) {
  Coat coat = thin_coat();
  const auto first = make_strands(coat), again = make_strands(coat);
  ASSERT_EQ(first.size(), 1500u);
  for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(first[i].root, again[i].root);
  coat.seed = 2;
  EXPECT_NE(make_strands(coat)[0].root, first[0].root);
}

TEST(Strands, CoverTheTileEvenly) {
  const auto strands = make_strands(thin_coat());
  std::array<int, 16> cells{};
  for (const Strand& strand : strands) {
    ASSERT_GE(strand.root.x, 0);
    ASSERT_LT(strand.root.x, thin_coat().tile);
    const glm::ivec2 cell(strand.root / thin_coat().tile * 4.0);
    ++cells[static_cast<std::size_t>(cell.y * 4 + cell.x)];
  }
  for (const int count : cells) EXPECT_NEAR(count, 1500 / 16, 20);
}

TEST(Strands, RootsNeverMove) {
  Coat coat = thin_coat();
  coat.bend = 1, coat.curl = 0.3;
  for (const Strand& strand : make_strands(coat)) EXPECT_LT(glm::length(strand_offset(coat, strand, 0)), 1e-12);
}

TEST(Ramp, GoesThroughItsStops) {
  Coat coat;
  coat.ramp = {{0.2, glm::vec3(0.1f)}, {0.6, glm::vec3(0.5f)}};
  EXPECT_FLOAT_EQ(ramp_colour(coat, 0).r, 0.1f);
  EXPECT_FLOAT_EQ(ramp_colour(coat, 0.4).r, 0.3f);
  EXPECT_FLOAT_EQ(ramp_colour(coat, 1).r, 0.5f);
}

/// Rays cross n discs (cut strands) and d t n strips between them on average. If they were placed at random, exp(-n) of
/// the rays would hit none; if none overlapped, 1 - n. Roots are placed more evenly than at random.
TEST(StrandCover, RaysHitStrandsByTheirWidthAndPath) {
  const Coat coat = plain_coat();
  const std::vector<Strand> strands = make_strands(coat);
  const std::array<double, slice_count> transmittance = ray_transmittance(coat, strands, 1);
  const double of_slice = coat.count * coat.width_root * nominal_length / slice_count / (coat.tile * coat.tile);
  const double discs = coat.count * std::numbers::pi * std::pow(coat.width_root / 2 / coat.tile, 2);
  for (const int slice : {31, 30, 28}) {
    const double hits = of_slice * (slice_count - slice) + discs;
    EXPECT_GT(transmittance[static_cast<std::size_t>(slice)], 1 - hits - 0.01) << slice;
    EXPECT_LT(transmittance[static_cast<std::size_t>(slice)], std::exp(-hits) + 0.01) << slice;
  }
  for (const std::vector<double>& cells : crossings_of(coat, strands))
    EXPECT_NEAR(std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size()), of_slice,
                1e-9 * of_slice);
}

/// At 75 degrees a ray moves several widths of a thin strand sideways in one slice, and must not miss strands in
/// between.
TEST(StrandCover, RaysHitEvenTheThinnestStrands) {
  Coat coat = plain_coat();
  coat.count = 600, coat.width_root = coat.width_tip = 0.00008;
  const double tangent = 3.7320508,
               hits = coat.count * coat.width_root * nominal_length * tangent / (coat.tile * coat.tile);
  const double transmittance = ray_transmittance(coat, make_strands(coat), tangent)[0];
  EXPECT_GT(transmittance, 1 - hits - 0.01);
  EXPECT_LT(transmittance, std::exp(-hits) + 0.02);
}

/// Straight down a ray only hits the discs of the roots, however long the strands are.
TEST(StrandCover, AlongUprightStrandsOnlyTheirEndsCount) {
  const Coat coat = plain_coat();
  const double discs = coat.count * std::numbers::pi * std::pow(coat.width_root / 2 / coat.tile, 2);
  for (const double share : ray_transmittance(coat, make_strands(coat), 0)) EXPECT_NEAR(share, std::exp(-discs), 0.01);
}

TEST(Slices, EveryLevelHasTheTransmittanceOfTheStrands) {
  for (const Coat& coat : {thin_coat(), Coat()}) {
    const Slices slices = bake_slices(coat);
    const std::vector<Strand> strands = make_strands(coat);
    ASSERT_EQ(slices.levels.size(), static_cast<std::size_t>(slice_levels));
    for (int i = 0; i < 6; ++i) {  // coarser levels are limited by 8 bits
      const SliceLevel& level = slices.levels[static_cast<std::size_t>(i)];
      EXPECT_NEAR(transmittance(coat, level, 0), ray_transmittance(coat, strands, 0)[0], 0.03) << "level " << i;
      for (const double angle : {30.0, 60.0, 75.0}) {
        if (angle > 70 && i == 0) continue;  // four steps per slice miss thin tips there
        const auto expected = ray_transmittance(coat, strands, std::tan(angle * std::numbers::pi / 180));
        for (const std::size_t slice : {28, 24, 20, 12})
          EXPECT_NEAR(transmittance(coat, level, angle, static_cast<int>(slice)), expected[slice], 0.07)
              << "level " << i << ", " << angle << " degrees, slice " << slice;
      }
    }
  }
}

// Holds for the tips too: slices below would make up for what the outermost ones leave out.
TEST(Slices, EverySliceOccludesItsShare) {
  Coat wide;
  wide.tile = 0.0625, wide.count = 2000, wide.width_root = 0.0012, wide.width_tip = 0.0008, wide.fine_clump = 0.3;
  for (const Coat& coat : {wide, Coat()}) {
    const Slices slices = bake_slices(coat);
    const auto expected = ray_transmittance(coat, make_strands(coat), std::tan(std::numbers::pi / 3));
    for (int slice = slice_count - 1; slice >= 20; --slice) {
      const double above = expected[static_cast<std::size_t>(slice)];
      EXPECT_NEAR(transmittance(coat, slices.levels[0], 60, slice), above, 0.1 * std::min(above, 1 - above) + 0.01)
          << slice;
    }
  }
}

// Rays that reach deeper see another colour of the ramp: 1 % of the height is about 1 % of its lightness.
TEST(Slices, RaysReachAsDeepAsBetweenStrands) {
  Coat sleek;
  sleek.count = 8400, sleek.width_root = 0.00042, sleek.width_tip = 0.00011, sleek.clump = 0.15,
  sleek.fine_clump = 0.25;
  for (const Coat& coat : {sleek, Coat()}) {
    const Slices slices = bake_slices(coat);
    const std::vector<Strand> strands = make_strands(coat);
    for (const double angle : {30.0, 75.0}) {
      const auto expected = ray_transmittance(coat, strands, std::tan(angle * std::numbers::pi / 180));
      for (const std::size_t i : {3, 5}) {
        double reached = 0;
        for (int slice = 0; slice < slice_count; ++slice)
          reached += transmittance(coat, slices.levels[i], angle, slice);
        EXPECT_NEAR(reached / slice_count, std::accumulate(expected.begin(), expected.end(), 0.0) / slice_count, 0.01)
            << "level " << i << ", " << angle << " degrees";
      }
    }
  }
}

/// Mean of the stored light in a slice; each texel has the `weight` of its depth.
template <typename Weight>
double mean_light(const SliceLevel& level, int slice, const Weight& weight) {
  double sum = 0, weights = 0;
  for (int y = 0; y < level.texels; ++y) {
    for (int x = 0; x < level.texels; ++x) {
      const std::size_t texel = (static_cast<std::size_t>(slice) * level.texels + y) * level.texels + x;
      const double w = weight(depth_at(level, x, y, slice));
      sum += w * level.shape[4 * texel + 2] / 255.0, weights += w;
    }
  }
  return sum / weights;
}

// More light falls into gaps between clumps than on strands; a texel of both lies in between.
TEST(Slices, CoarseLevelsLieBetweenTheLightOfStrandsAndOfGaps) {
  Coat coat;
  coat.clump = 0.9, coat.clump_size = 0.02;
  const Slices slices = bake_slices(coat);
  constexpr int slice = 20;
  const double everywhere = mean_light(slices.levels[0], slice, [](double) { return 1.0; });
  const double on_strands = mean_light(slices.levels[0], slice, [](double depth) { return depth > 0.2 ? 1.0 : 0.0; });
  ASSERT_GT(everywhere, on_strands + 0.03);
  const double coarse = mean_light(slices.levels[7], slice, [](double depth) { return depth; });
  EXPECT_LT(coarse, everywhere - 0.25 * (everywhere - on_strands));
  EXPECT_GT(coarse, on_strands);
}

TEST(Slices, ThinTowardsTheTips) {
  const Slices slices = bake_slices(thin_coat());
  const SliceLevel& level = slices.levels[0];
  const auto covered = [&](int slice) {
    double sum = 0;
    for (int y = 0; y < level.texels; ++y) {
      for (int x = 0; x < level.texels; ++x) sum += depth_at(level, x, y, slice);
    }
    return sum;
  };
  EXPECT_GT(covered(2), covered(16));
  EXPECT_GT(covered(16), covered(30));
  EXPECT_GT(covered(30), 0);
}

TEST(Slices, LightFallsTowardsTheRoots) {
  const Slices slices = bake_slices(Coat());
  EXPECT_GT(slices.depth_above[0], slices.depth_above[16]);
  EXPECT_GT(slices.depth_above[16], slices.depth_above[31]);
  EXPECT_NEAR(slices.depth_above[31], 0, 0.1);
}

TEST(Slices, GiveTheSameBitsEveryTime) {
  const Slices first = bake_slices(thin_coat()), again = bake_slices(thin_coat());
  for (std::size_t i = 0; i < first.levels.size(); ++i) {
    ASSERT_EQ(first.levels[i].shape, again.levels[i].shape);
    ASSERT_EQ(first.levels[i].colour, again.levels[i].colour);
  }
}

TEST(Slices, StopForGoodOnceToldTo) {
  std::atomic<int> asked{0};
  const Slices slices = bake_slices(thin_coat(), [&] { return ++asked != 2; });
  EXPECT_TRUE(slices.levels.empty()) << "a slice is missing";
}

// 100,000 discs of ten tiles each would take days if the loop over tiles did not end early.
TEST(Slices, TheWidestStrandsAreOpaqueAndEnd) {
  Coat coat;
  coat.count = 100'000, coat.tile = 0.01, coat.width_root = coat.width_tip = 0.05, coat.length_spread = 0;
  coat.undercoat = {.share = 0.5, .length = 1, .width = 4};
  const Slices slices = bake_slices(coat);
  const SliceLevel& level = slices.levels[0];
  for (std::size_t i = 3; i < level.shape.size() / 2; i += 4) ASSERT_EQ(level.shape[i], 255);  // the lower half
}

TEST(Slices, ExtremesAreFinite) {
  for (const auto& [count, width, bend] : {std::tuple{1, 0.0, 0.0}, {1, 0.05, 2.0}, {20000, 0.002, 2.0}}) {
    Coat coat;
    coat.count = count, coat.width_root = coat.width_tip = width, coat.bend = bend, coat.curl = 0.5;
    const Slices slices = bake_slices(coat);
    for (const SliceLevel& level : slices.levels) {
      for (const double scale : level.depth_scale) EXPECT_TRUE(std::isfinite(scale));
    }
    for (const float depth : slices.depth_above) EXPECT_TRUE(std::isfinite(depth));
  }
}

}  // namespace
}  // namespace pelage
