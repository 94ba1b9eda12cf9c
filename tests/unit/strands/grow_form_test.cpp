// The shape of grown strands, against the lean curve, the slices and the formulas of the shaders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "base/lean_curve.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/tufts.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

constexpr double turn = 2 * std::numbers::pi;

double arc_length(const StrandSet& set, std::size_t strand) {
  double sum = 0;
  for (int k = 0; k < set.segments; ++k)
    sum += glm::distance(knot(set, strand, k).position, knot(set, strand, k + 1).position);
  return sum;
}

const Strand& strand_of(const std::vector<Strand>& strands, float number) {
  return *std::find_if(strands.begin(), strands.end(),
                       [&](const Strand& strand) { return static_cast<float>(strand.number) == number; });
}

TEST(GrowForm, FollowsTheLeanCurve) {
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    for (const float inclination : {0.0f, 0.123f, 0.5f, 0.777f, 1.0f}) {
      GrowRecipe recipe{plain_coat(50)};
      recipe.coat.lean_curve = curve, recipe.coat.root_share = 0.3;
      FurPatch patch(0.12, 1, 0.05f);
      patch.direction.assign(4, glm::vec2(0.6f, 0.8f) * inclination);
      const StrandSet set = patch.grow(recipe);
      ASSERT_GT(set.count(), 40u);
      for (std::size_t i = 0; i < set.count(); ++i) {
        for (int k = 0; k <= set.segments; ++k) {
          const LeanPoint at = lean_point(curve, inclination, 0.3, static_cast<double>(k) / set.segments);
          const glm::dvec3 expected(0.6 * at.across, 0.8 * at.across, at.up);
          const glm::dvec3 position = knot(set, i, k).position - knot(set, i, 0).position;
          ASSERT_LT(glm::distance(position, 0.05 * expected), 1e-6) << inclination << ' ' << k;
        }
        ASSERT_NEAR(arc_length(set, i), 0.05, 0.05 * 0.003);
      }
    }
  }
}

/// Between corners, strands are interpolated as shells are: halfway between two corners the tip is halfway too.
TEST(GrowForm, PositionsAreMixedAsShellsMixThem) {
  GrowRecipe recipe{plain_coat(3000)};
  FurPatch patch(0.12, 1);
  patch.length = {0.01f, 0.05f, 0.02f, 0.03f};
  patch.direction = {{0.5f, 0}, {0, 0.9f}, {-0.3f, 0.3f}, {0, 0}};
  const StrandSet set = patch.grow(recipe);
  const auto corner_tip = [&](std::uint32_t v) {
    const double inclination = glm::length(patch.direction[v]);
    const glm::dvec2 heading = inclination > 0 ? glm::dvec2(patch.direction[v]) / inclination : glm::dvec2(1, 0);
    const LeanPoint at = lean_point(LeanCurve::arc, inclination, 0, 1);
    return glm::dvec3(patch.positions[v]) +
           static_cast<double>(patch.length[v]) * glm::dvec3(heading * at.across, at.up);
  };
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::dvec2 at = glm::dvec2(knot(set, i, 0).position) / static_cast<double>(patch.positions[3].x);
    const bool lower = at.x > at.y;  // triangle of vertices 0 1 3, or 0 3 2
    const double third = std::min(at.x, at.y), second = std::abs(at.x - at.y);
    const glm::dvec3 expected =
        (1 - third - second) * corner_tip(0) + second * corner_tip(lower ? 1 : 2) + third * corner_tip(3);
    ASSERT_LT(glm::distance(glm::dvec3(tip(set, i).position), expected), 1e-6) << i;
  }
}

TEST(GrowForm, OffsetsAreTheTiles) {
  Coat coat;
  coat.count = 300, coat.curl = 0.1, coat.wave = 0.1, coat.mess = 0.2, coat.fine_clump = 0.5, coat.wetness = 0.3;
  FurPatch patch(0.12, 1, 0.2f);  // so long that no offset is limited
  const std::vector<Strand> strands = make_strands(coat);
  const StrandSet set = patch.grow({coat});
  EXPECT_EQ(set.segments, 24);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const Strand& strand = strand_of(strands, set.roots[i].number);
    for (int k = 0; k <= set.segments; ++k) {
      const double q = static_cast<double>(k) / set.segments;
      const glm::dvec2 expected = strand_offset(coat, strand, q);
      const glm::dvec3 position = knot(set, i, k).position - knot(set, i, 0).position;
      ASSERT_LT(glm::distance(position, glm::dvec3(expected, 0.2 * strand.length_share * q)), 2e-6);
      const double radius = 0.5 * strand.width * glm::mix(coat.width_root, coat.width_tip, q);
      ASSERT_NEAR(knot(set, i, k).radius, radius, 1e-9);
    }
  }
}

TEST(GrowForm, TileAxesTurnOffsets) {
  Coat coat = plain_coat(100);
  coat.bend = 0.5;
  FurPatch patch(0.12, 1, 0.2f);
  for (auto& corners : patch.corners) {
    for (FurCorner& corner : corners) corner.tile_axis = {0.0f, 0.8f, 0.6f};  // not quite in the skin's plane
  }
  const StrandSet set = patch.grow({coat});
  const std::vector<Strand> strands = make_strands(coat);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::dvec2 offset = strand_offset(coat, strand_of(strands, set.roots[i].number), 1);
    const glm::dvec3 position = tip(set, i).position - knot(set, i, 0).position;
    ASSERT_LT(glm::distance(position, glm::dvec3(-offset.y, offset.x, 0.2)), 1e-6);
  }
}

TEST(GrowForm, TurnsWithTheModel) {
  const GrowRecipe recipe{Coat{.count = 200, .curl = 0.1}};
  FurPatch patch(0.12, 2);
  patch.direction.assign(patch.positions.size(), {0.3f, -0.5f});
  const StrandSet level = patch.grow(recipe);
  const glm::mat3 turned(glm::vec3(0.36f, 0.48f, -0.8f), glm::vec3(-0.8f, 0.6f, 0), glm::vec3(0.48f, 0.64f, 0.6f));
  patch.rest_positions = patch.positions, patch.rest_normals = patch.normals;  // strands keep their order
  for (auto* vectors : {&patch.positions, &patch.normals, &patch.tangents}) {
    for (glm::vec3& v : *vectors) v = turned * v;
  }
  for (auto& corners : patch.corners) {
    for (FurCorner& corner : corners) corner.tile_axis = turned * corner.tile_axis;
  }
  const StrandSet set = patch.grow(recipe);
  ASSERT_EQ(set.count(), level.count());
  for (std::size_t i = 0; i < set.points.size(); ++i)
    ASSERT_LT(glm::distance(set.points[i].position, turned * level.points[i].position), 1e-6f);
  EXPECT_LT(glm::distance(set.roots[0].normal, turned * level.roots[0].normal), 1e-6f);
}

TEST(GrowForm, ShortFurIsNotWiderThanLong) {
  Coat coat;
  coat.count = 500, coat.bend = 2, coat.curl = 0.5, coat.mess = 1, coat.clump = 1, coat.clump_size = 0.05;
  for (const float fur : {0.0025f, 0.01f, 0.03f}) {
    const FurPatch patch(0.12, 1, fur);
    const StrandSet set = patch.grow({coat});
    ASSERT_GT(set.count(), 400u);
    double widest = 0;
    for (std::size_t i = 0; i < set.count(); ++i) {
      for (int k = 0; k <= set.segments; ++k) {
        const glm::vec2 side(knot(set, i, k).position - knot(set, i, 0).position);
        ASSERT_LE(glm::length(side), fur * set.roots[i].reach * 1.0001f + 1e-7f);
        widest = std::max<double>(widest, glm::length(side));
      }
    }
    EXPECT_GT(widest, 0.5 * fur);
  }
}

TEST(GrowForm, PaintedCurl) {
  Coat coat = plain_coat(200);
  coat.curl = 0.1, coat.curl_turns = 2;
  FurPatch patch(0.24, 1, 0.3f);
  const StrandSet own = patch.grow({coat});
  const std::vector<float> curl(4, 0.25f);
  patch.paint.curl = curl;
  const StrandSet set = patch.grow({coat});
  ASSERT_EQ(set.count(), own.count());
  EXPECT_EQ(set.segments, 16);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::dvec2 tile = glm::dvec2(knot(set, i, 0).position) / coat.tile;
    for (int k = 0; k <= set.segments; ++k) {
      const double s = static_cast<double>(k) / set.segments;
      const double angle = turn * 2 * s + 2.2 * (std::sin(turn * tile.x + 0.7) + std::sin(turn * tile.y + 2.1));
      const glm::dvec2 expected = 0.25 * 0.03 * std::min(1.0, 4 * s) * glm::dvec2(std::cos(angle), std::sin(angle));
      const glm::dvec3 more = knot(set, i, k).position - knot(own, i, k).position;
      ASSERT_LT(glm::distance(more, glm::dvec3(expected, 0)), 5e-7) << k;
    }
  }
  const std::vector<float> max(4, 0.9f);  // more than the maximum of .5
  patch.paint.curl = max;
  const StrandSet curliest = patch.grow({coat});
  EXPECT_NEAR(glm::distance(tip(curliest, 0).position, tip(own, 0).position), 0.4 * 0.03, 1e-6);
}

TEST(GrowForm, PaintedClumpAndWaterGather) {
  Coat coat = plain_coat(500);
  coat.clump_size = 0.02;
  const ClumpGrid grid(coat.tile, coat.clump_size, coat.seed, 1);
  for (const bool wet : {false, true}) {
    FurPatch patch(0.12, 1, 0.3f);
    const std::vector<float> amount(4, 0.6f);
    (wet ? patch.paint.wetness : patch.paint.clump) = amount;
    const StrandSet set = patch.grow({coat});
    const double painted = wet ? 0.85 * 0.6 : 0.6;
    for (std::size_t i = 0; i < set.count(); ++i) {
      const glm::dvec2 root(knot(set, i, 0).position);
      const StrandClump clump = grid.nearest(root);
      for (int k = 0; k <= set.segments; ++k) {
        const double s = static_cast<double>(k) / set.segments;
        const double part = 0.8 * painted * (0.5 + 0.5 * clump.pull) * std::pow(s, 1.5);
        const glm::dvec2 side(knot(set, i, k).position - knot(set, i, 0).position);
        ASSERT_LT(glm::distance(side, part * (clump.centre - root)), 1e-6);
      }
      EXPECT_FLOAT_EQ(set.roots[i].wetness, wet ? 0.6f : 0.0f);
    }
  }
}

/// The tile position that the shader looks up for a pulled strand is that of the strand before the pull.
TEST(GrowForm, ShadersFindTheStrandThatWasPulled) {
  Coat coat = plain_coat(500);
  coat.bend = 0.4, coat.clump_size = 0.02;
  FurPatch patch(0.12, 1, 0.3f);
  const StrandSet own = patch.grow({coat});
  const std::vector<float> clump_field(4, 0.7f);
  patch.paint.clump = clump_field;
  const StrandSet set = patch.grow({coat});
  const ClumpGrid grid(coat.tile, coat.clump_size, coat.seed, 1);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const StrandClump clump = grid.nearest(glm::dvec2(knot(set, i, 0).position));
    const double part = 0.8 * 0.7 * (0.5 + 0.5 * clump.pull);
    const glm::dvec2 here(tip(set, i).position), middle = clump.centre - here;
    const glm::dvec2 looked_up = here - middle * (part / (1 - part));
    ASSERT_LT(glm::distance(looked_up, glm::dvec2(tip(own, i).position)), 2e-6);
  }
}

TEST(GrowForm, TuftsGatherByTheirMiddle) {
  Coat coat = plain_coat(500);
  coat.tufts.gather = 0.8, coat.tufts.size = 0.05;
  for (const float fur : {0.2f, 0.005f}) {
    const FurPatch patch(0.3, 2, fur);
    const StrandSet set = patch.grow({coat});
    for (std::size_t i = 0; i < set.count(); ++i) {
      const glm::vec3 root = knot(set, i, 0).position;
      const TuftPull tuft = tuft_at(coat.tufts, root, {0, 0, 1});
      const double radius = glm::length(tuft.to_middle) / std::max(1 - tuft.inside, 0.05f);
      const double part = gathered(coat.tufts, 1) * std::min(1.0, fur / radius);
      const glm::vec3 side = tip(set, i).position - root - glm::vec3(0, 0, fur);
      ASSERT_LT(glm::distance(glm::dvec3(side), part * glm::dvec3(tuft.to_middle)), 1e-5);
      ASSERT_LT(glm::length(side), fur);
    }
  }
}

/// The patch moved and rotated, with its rest pose.
FurPatch moved(const FurPatch& rest, const glm::mat3& by, glm::vec3 away) {
  FurPatch patch = rest;
  patch.rest_positions = rest.positions, patch.rest_normals = rest.normals;
  for (glm::vec3& p : patch.positions) p = by * p + away;
  for (glm::vec3& n : patch.normals) n = by * n;
  for (glm::vec3& t : patch.tangents) t = by * t;
  for (auto& corners : patch.corners)
    for (FurCorner& corner : corners) corner.tile_axis = by * corner.tile_axis;
  return patch;
}

TEST(GrowForm, PatternVariationAndTuftsGoAlongWithAModelThatMoves) {
  Coat coat = plain_coat(200);
  coat.pattern.kind = PatternKind::spots, coat.tufts.gather = 0.8, coat.tufts.size = 0.05;
  coat.variation.length = 0.8, coat.variation.lean = 0.6, coat.variation.lightness = 0.5;
  FurPatch patch(0.4, 8);
  patch.direction.assign(patch.positions.size(), {0.4f, 0.2f});
  const glm::mat3 by(glm::rotate(glm::dmat4(1), 2.0, glm::normalize(glm::dvec3(1, 2, 3))));
  const glm::vec3 away(0.3f, -0.2f, 0.1f);
  FurPatch other = moved(patch, by, away);
  const StrandSet before = patch.grow({coat}), after = other.grow({coat});
  ASSERT_EQ(before.count(), after.count());
  ASSERT_EQ(before.colours, after.colours);
  for (std::size_t i = 0; i < before.points.size(); ++i)
    ASSERT_LT(glm::distance(by * before.points[i].position + away, after.points[i].position), 1e-5f) << i;
  other.rest_positions.clear(), other.rest_normals.clear();
  EXPECT_NE(other.grow({coat}).colours, before.colours);  // without the rest pose the pattern stays in space
}

TEST(GrowForm, VariationChangesLengthAndLean) {
  Coat coat = plain_coat(300);
  coat.variation.length = 0.8, coat.variation.lean = 0.6;
  FurPatch patch(0.4, 40);
  patch.direction.assign(patch.positions.size(), {0.5f, 0});
  const StrandSet set = patch.grow({coat});
  const PatternBlock block = make_pattern_block(coat);
  double lowest = 1, highest = 0;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const glm::vec3 root = knot(set, i, 0).position;
    const double length = 0.03 * pattern_length(block, root),
                 lean = std::clamp(0.5f + pattern_lean(block, root), 0.0f, 1.0f);
    const LeanPoint at = lean_point(LeanCurve::arc, lean, 0, 1);
    const glm::dvec3 position = tip(set, i).position - root;
    ASSERT_LT(glm::distance(position, length * glm::dvec3(at.across, 0, at.up)), 0.02 * length + 1e-5);
    lowest = std::min(lowest, length), highest = std::max(highest, length);
  }
  EXPECT_GT(highest, 1.3 * lowest);
}

// Guard hairs stand upright here, with .8 to 1.25 of the fur's length and a bow of up to bend + mess.
TEST(GrowForm, GuardHairsReachBeyondTheFur) {
  Coat coat = plain_coat(2000);
  coat.bend = 0.2, coat.clump = 0.5, coat.length_spread = 0.5;
  FurPatch patch(0.12, 1, 0.04f);
  const StrandSet none = patch.grow({coat}), some = patch.grow({.coat = coat, .guard_share = 0.1});
  ASSERT_EQ(some.count(), none.count());
  EXPECT_NEAR(static_cast<double>(none.count() - count_shared(some, none)), 200, 60);
  double tallest = 0;
  for (std::size_t i = 0; i < some.count(); ++i) {
    const glm::dvec3 to_tip = tip(some, i).position - knot(some, i, 0).position;
    tallest = std::max(tallest, to_tip.z / 0.04);
    if (to_tip.z > 0.0401) {
      EXPECT_NEAR(glm::length(glm::dvec2(to_tip)), 0.2 * nominal_length, 1e-6);
    }
  }
  EXPECT_GT(tallest, 1.2);
  EXPECT_LE(tallest, 1.25001);
  const StrandSet all = patch.grow({.coat = coat, .guard_share = 1});
  for (std::size_t i = 0; i < all.count(); ++i) EXPECT_GE(tip(all, i).position.z, 0.8f * 0.04f - 1e-6f);
}

TEST(GrowForm, WidthIsPaintedAndWidened) {
  FurPatch patch(0.12);
  const StrandSet own = patch.grow({plain_coat(100)});
  const std::vector<float> width(4, 0.5f);
  patch.paint.width = width;
  const StrandSet set = patch.grow({.coat = plain_coat(100), .widening = 3});
  for (std::size_t i = 0; i < own.points.size(); ++i)
    EXPECT_FLOAT_EQ(set.points[i].radius, 1.5f * own.points[i].radius);
}

/// Coverage of each texel of a slice by the strands at a height, supersampled.
std::vector<float> rasterised(const StrandSet& set, double s, double tile) {
  constexpr int finer = 4, side = slice_texels * finer;
  std::vector<std::uint8_t> covered(static_cast<std::size_t>(side) * side);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const double reach = set.roots[i].reach, at = std::min(1.0, s / reach) * set.segments;
    const double inside = (reach - s) * slice_count + 0.5;  // part of the slice's slab below the strand's tip
    if (inside <= 0) continue;
    const int k = std::min(static_cast<int>(at), set.segments - 1);
    const glm::dvec2 position(
        glm::mix(knot(set, i, k).position, knot(set, i, k + 1).position, static_cast<float>(at - k)));
    const double thick = glm::mix(knot(set, i, k).radius, knot(set, i, k + 1).radius, static_cast<float>(at - k));
    const double radius = thick * std::min(1.0, inside) / tile * side;
    const glm::dvec2 centre = position / tile * double(side);
    for (int y = static_cast<int>(std::floor(centre.y - radius)); y <= centre.y + radius; ++y) {
      for (int x = static_cast<int>(std::floor(centre.x - radius)); x <= centre.x + radius; ++x) {
        if (glm::distance(centre, glm::dvec2(x + 0.5, y + 0.5)) > radius) continue;
        covered[static_cast<std::size_t>(y & (side - 1)) * side + static_cast<std::size_t>(x & (side - 1))] = 1;
      }
    }
  }
  std::vector<float> shares(slice_texels * slice_texels);
  for (std::size_t i = 0; i < covered.size(); ++i)
    shares[i / side / finer * slice_texels + i % side / finer] += covered[i] / float(finer * finer);
  return shares;
}

TEST(GrowAndSlices, CoverTheSamePositions) {
  Coat coat;
  coat.tile = 0.0625;  // exact in float
  coat.count = 2000, coat.width_root = 0.0012, coat.width_tip = 0.0008, coat.fine_clump = 0.3;
  const Slices slices = bake_slices(coat);
  const StrandSet set = FurPatch(0.0625, 1, 0.2f).grow({coat});
  ASSERT_EQ(set.count(), 2000u);
  for (const int slice : {0, 8, 16, 22, 26}) {
    const std::vector<float> strands = rasterised(set, (slice + 0.5) / slice_count, coat.tile);
    double sum = 0, of_strands = 0, apart = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
      const double stored = slices.levels[0].shape[4 * (static_cast<std::size_t>(slice) * strands.size() + i) + 3];
      const double share = -std::expm1(-stored / 255 * stored_depth * slices.levels[0].depth_scale[1]);
      sum += share, of_strands += strands[i], apart += std::abs(share - strands[i]);
    }
    EXPECT_NEAR(of_strands / sum, 0.955, 0.105) << slice;  // the bake thickens rims at the tips, for slanted rays
    EXPECT_LT(apart / sum, 0.25) << slice;                 // and blurs over a texel, while this is sharp
  }
}

TEST(GrowCurves, AreTheStripsOfTheCurves) {
  FurCurves whiskers;
  whiskers.guides = {{{{0, 0, 0}, {0, 0, 0.1}}, {0, 1, 0}}, {{{0.1, 0, 0}, {0.1, 0.02, 0.1}}}};
  whiskers.width_root = 0.002, whiskers.width_tip = 0, whiskers.fill = 3;
  whiskers.root_colour = {1, 1, 1}, whiskers.tip_colour = {0, 0, 0};
  const StrandSet set = grow_curves({&whiskers, 1});
  ASSERT_EQ(set.count(), 5u);
  EXPECT_EQ(set.points.size(), 5u * static_cast<unsigned>(set.segments + 1));
  EXPECT_FLOAT_EQ(knot(set, 0, 0).radius, 0.001f);
  EXPECT_FLOAT_EQ(tip(set, 0).radius, 1e-7f);
  EXPECT_LT(glm::distance(tip(set, 0).position, glm::vec3(0, 0, 0.1f)), 1e-6f);
  EXPECT_EQ(set.roots[0].reach, 1);
  EXPECT_EQ(set.roots[0].normal, glm::vec3(0, 1, 0));
  EXPECT_NEAR(unpack_colour(set.colours[24]).r, 0.5, 0.01);
  EXPECT_EQ(grow_curves({}).count(), 0u);
}

}  // namespace
}  // namespace pelage
