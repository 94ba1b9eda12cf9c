// Which strands grow, and where their roots are.
#include "renderer/strands/grow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "renderer/coat/strand_tile.h"
#include "renderer/strands/tile_strands.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

/// Moves the inner vertices of a patch at random, so that its triangles all differ.
void shake(FurPatch& patch, int quads, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int y = 1; y < quads; ++y) {
    for (int x = 1; x < quads; ++x) {
      glm::vec3& position = patch.positions[static_cast<std::size_t>(y * (quads + 1) + x)];
      position += glm::vec3(uniform(random), uniform(random), 0) * static_cast<float>(0.3 * step);
    }
  }
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      patch.corners[i][static_cast<std::size_t>(k)].tile_uv = glm::vec2(patch.positions[patch.triangles[i][k]]);
  }
}

std::vector<float> numbers(const StrandSet& set) {
  std::vector<float> result;
  for (const StrandRoot& root : set.roots) result.push_back(root.number);
  return result;
}

TEST(Grow, AsManyAsTheTileHasOnTheArea) {
  const GrowRecipe recipe{plain_coat()};
  const FurPatch patch(0.3, 4);
  const double expected = 0.3 * 0.3 / (recipe.coat.tile * recipe.coat.tile) * recipe.coat.count;
  EXPECT_NEAR(expected_strands(patch.model(), recipe.coat), expected, 1e-3 * expected);
  EXPECT_NEAR(static_cast<double>(patch.grow(recipe).count()), expected, 0.02 * expected);
}

TEST(Grow, OneTileHasEachStrandOnce) {
  const GrowRecipe recipe{plain_coat()};
  for (const int quads : {1, 3, 7}) {
    const float side = static_cast<float>(recipe.coat.tile);
    const StrandSet set = FurPatch(side, quads).grow(recipe);
    EXPECT_NEAR(static_cast<double>(set.count()), 1000, 1);  // in float the side is not exactly the tile's
    std::vector<float> found = numbers(set);
    std::sort(found.begin(), found.end());
    EXPECT_LE(std::unique(found.begin(), found.end()) - found.begin(), 1000);
  }
}

TEST(Grow, AnySplitOfAPatchGrowsTheSameRoots) {
  const GrowRecipe recipe{plain_coat(4000)};
  const std::size_t whole = FurPatch(0.25, 1).grow(recipe).count();
  for (unsigned seed = 0; seed < 20; ++seed) {
    const int quads = 2 + static_cast<int>(seed % 7);
    FurPatch patch(0.25, quads);
    shake(patch, quads, 0.25 / quads, seed);
    const StrandSet set = patch.grow(recipe);
    EXPECT_EQ(set.count(), whole) << seed;
    std::vector<glm::vec3> roots;
    for (std::size_t i = 0; i < set.count(); ++i) roots.push_back(knot(set, i, 0).position);
    std::sort(roots.begin(), roots.end(), [](glm::vec3 a, glm::vec3 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    for (std::size_t i = 1; i < roots.size(); ++i)
      ASSERT_GT(glm::distance(roots[i - 1], roots[i]), 1e-6f) << seed;  // no root twice
  }
}

TEST(Grow, RootsLieWhereTheTilePutsThem) {
  const GrowRecipe recipe{Coat{.count = 500}};
  const FurPatch patch(0.12, 2);
  const std::vector<Strand> strands = make_strands(recipe.coat);
  const StrandSet set = patch.grow(recipe);
  for (std::size_t i = 0; i < set.count(); ++i) {
    const auto same = std::find_if(strands.begin(), strands.end(), [&](const Strand& strand) {
      return static_cast<float>(strand.number) == set.roots[i].number;
    });
    ASSERT_NE(same, strands.end());
    EXPECT_NEAR(knot(set, i, 0).position.x, same->root.x, 1e-7);
    EXPECT_NEAR(knot(set, i, 0).position.y, same->root.y, 1e-7);
    EXPECT_EQ(knot(set, i, 0).position.z, 0);
    EXPECT_EQ(set.roots[i].normal, glm::vec3(0, 0, 1));
    EXPECT_FLOAT_EQ(set.roots[i].reach, static_cast<float>(same->length_share));
  }
}

TEST(Grow, DensityKeepsLowNumbers) {
  const GrowRecipe recipe{plain_coat(5000)};
  FurPatch patch(0.2, 3);
  const StrandSet whole = patch.grow(recipe);
  const std::vector<float> half(patch.positions.size(), 0.5f);
  patch.paint.density = half;
  const StrandSet thin = patch.grow(recipe);
  const std::vector<float> all = numbers(whole), remaining = numbers(thin);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](float n) { return n < 0.5f; }),
            static_cast<std::ptrdiff_t>(remaining.size()));
  EXPECT_LT(*std::max_element(remaining.begin(), remaining.end()), 0.5f);
  EXPECT_EQ(count_shared(thin, whole), thin.count());
}

TEST(Grow, ASmallerShareIsASubset) {
  const FurPatch patch(0.3, 3);
  StrandSet larger = patch.grow({plain_coat(5000)});
  for (const double share : {0.6, 0.25, 0.01}) {
    const StrandSet set = patch.grow({plain_coat(5000), false, share});
    const double expected = 31250 * share, deviation = std::sqrt(expected * (1 - share));
    EXPECT_NEAR(static_cast<double>(set.count()), expected, 5 * deviation);
    EXPECT_EQ(count_shared(set, larger), set.count());
    larger = set;
  }
}

TEST(Grow, WeightAndShortFurKeepTheirShare) {
  FurPatch patch(0.3, 3);
  for (auto& corners : patch.corners) {
    for (FurCorner& corner : corners) corner.weight = 0.3f;
  }
  const GrowRecipe recipe{plain_coat(5000)};
  EXPECT_NEAR(static_cast<double>(patch.grow(recipe).count()), 0.3 * 31250, 5 * std::sqrt(0.21 * 31250));
  EXPECT_NEAR(expected_strands(patch.model(), recipe.coat), 0.3 * 31250, 10);
  const FurPatch stubble(0.3, 3, 0.001f);
  EXPECT_NEAR(static_cast<double>(stubble.grow(recipe).count()), 0.5 * 31250, 5 * std::sqrt(0.25 * 31250));
}

TEST(Grow, OtherCopiesOfTheTileKeepOtherStrands) {
  GrowRecipe recipe{plain_coat(1000)};
  recipe.share = 0.5;
  const std::vector<float> remaining = numbers(FurPatch(0.24, 1).grow(recipe));  // 2 x 2 tiles
  std::vector<int> times(1000);
  for (const Strand& strand : make_strands(recipe.coat)) {
    const auto n = std::count(remaining.begin(), remaining.end(), static_cast<float>(strand.number));
    if (n == 0 || n == 4) ++times[0];
  }
  EXPECT_NEAR(times[0], 1000 / 8, 60);  // random; 1000 if all copies kept the same strands
}

TEST(Grow, ChunksDoNotMatter) {
  Coat coat;
  coat.count = 2000;
  const GrowRecipe recipe{coat};
  FurPatch patch(0.3, 6);
  shake(patch, 6, 0.05, 3);
  const Grower grower = patch.grower(recipe);
  const auto whole = sorted_strands(grower.grow(patch.all()));
  for (const std::size_t each : {1u, 500u, 3000u, 1000000u}) {
    std::vector<StrandChunk> chunks = make_chunks(patch.model(), coat, static_cast<double>(each));
    std::reverse(chunks.begin(), chunks.end());
    StrandSet sum;
    for (const StrandChunk& chunk : chunks) {
      const StrandSet part = grower.grow(chunk);
      sum.segments = part.segments;
      sum.points.insert(sum.points.end(), part.points.begin(), part.points.end());
      sum.colours.insert(sum.colours.end(), part.colours.begin(), part.colours.end());
      sum.roots.insert(sum.roots.end(), part.roots.begin(), part.roots.end());
    }
    EXPECT_EQ(sorted_strands(sum), whole) << each;
  }
}

TEST(GrowChunks, HoldEachTriangleOnceAndLieTogether) {
  const FurPatch patch(0.6, 16);
  const Coat coat = plain_coat(9000);
  const std::vector<StrandChunk> chunks = make_chunks(patch.model(), coat, 8000);
  EXPECT_GT(static_cast<double>(chunks.size()), 225000.0 / 8000);
  EXPECT_LT(static_cast<double>(chunks.size()), 2 * 225000.0 / 8000);
  std::vector<int> times(patch.triangles.size());
  double extents = 0;
  for (const StrandChunk& chunk : chunks) {
    glm::vec3 low(9), high(-9);
    double strands = 0;
    for (const std::uint32_t triangle : chunk) {
      ++times[triangle], strands += expected_strands(patch.corners[triangle], coat);
      low = glm::min(low, patch.positions[patch.triangles[triangle].x]);
      high = glm::max(high, patch.positions[patch.triangles[triangle].x]);
    }
    extents += glm::length(high - low);
    EXPECT_LE(strands, 8000);
  }
  EXPECT_LT(extents / static_cast<double>(chunks.size()), 0.25);  // .16 for a square of the same area
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
  EXPECT_TRUE(make_chunks(FurModel{}, coat, 8000).empty());
}

TEST(Grow, BareSkinGrowsNone) {
  FurPatch patch(0.4, 8);
  FurSkinRegion region;
  region.centre = {0.2, 0.2, 0}, region.softness = 0.2;
  region.to_unit = glm::dmat3(1 / 0.1);
  patch.skin.push_back(region);
  const GrowRecipe recipe{plain_coat(3000)};
  const StrandSet set = patch.grow(recipe);
  EXPECT_LT(set.count(), expected_strands(patch.model(), recipe.coat) - 1000);
  for (std::size_t i = 0; i < set.count(); ++i)
    ASSERT_GT(glm::distance(knot(set, i, 0).position, glm::vec3(0.2f, 0.2f, 0)), 0.03f);
  const std::vector<float> bare(patch.positions.size(), 1.0f);
  patch.paint.bare = bare;
  EXPECT_EQ(patch.grow(recipe).count(), 0u);
}

TEST(GrowFingerprint, FollowsEachFieldAtItsOwnVertices) {
  FurPatch patch(0.4, 8);
  const std::size_t vertices = patch.positions.size();
  const GrowRecipe recipe{plain_coat(100)};
  const StrandChunk near{0, 1}, far{126, 127};
  std::vector<float> numbers_at(vertices, 0.5f);
  std::vector<glm::vec4> colours_at(vertices, glm::vec4(0.5f));
  const FurFields rest = patch.fields();
  for (int field = 0; field < 10; ++field) {
    FurFields fields = rest;
    std::span<const float>* spans[] = {&fields.length,     &fields.paint.density, &fields.paint.width,
                                       &fields.paint.curl, &fields.paint.clump,   &fields.paint.wetness,
                                       &fields.paint.bare};
    std::vector<glm::vec2> direction = patch.direction;
    if (field < 7) *spans[field] = numbers_at;
    if (field == 7) fields.direction = direction;
    if (field == 8) fields.paint.root_colour = colours_at;
    if (field == 9) fields.paint.tip_colour = colours_at;
    const Grower before(patch.model(), fields, recipe);
    numbers_at[0] = 0.25f, colours_at[0].r = 0.25f, direction[0].y = 0.25f;
    const Grower after(patch.model(), fields, recipe);
    numbers_at[0] = 0.5f, colours_at[0].r = 0.5f;
    EXPECT_NE(before.fingerprint(near), after.fingerprint(near)) << field;
    EXPECT_EQ(before.fingerprint(far), after.fingerprint(far)) << field;
  }
}

TEST(GrowFingerprint, FollowsTheRecipe) {
  const FurPatch patch(0.2, 2);
  const GrowRecipe recipe{Coat{.count = 100}};
  std::vector<GrowRecipe> others(16, recipe);
  others[0].coat.seed = 2, others[1].coat.width_tip *= 2, others[2].coat.ramp[0].colour.r = 0.5f;
  others[3].coat.root_share = 0.5, others[4].coat.lean_curve = LeanCurve::root, others[5].coat.tufts.gather = 0.5;
  others[6].coat.pattern.kind = PatternKind::spots, others[7].coat.variation.lightness = 0.5;
  others[8].model_colours = true, others[9].share = 0.5, others[10].widening = 2, others[11].coat.bend = 1;
  others[12].coat.tile = 0.2, others[13].coat.wetness = 0.5, others[14].coat.tufts.seed = 9, others[15].coat.curl = 0.1;
  const auto fingerprint = [&](const GrowRecipe& r) { return patch.grower(r).fingerprint(patch.all()); };
  const std::uint64_t own = fingerprint(recipe);
  EXPECT_EQ(fingerprint(recipe), own);
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_NE(fingerprint(others[i]), own) << i;
  FurPatch bald_spot = patch;
  FurSkinRegion region;
  region.to_unit = glm::dmat3(1 / 0.05);
  bald_spot.skin.push_back(region);
  EXPECT_NE(bald_spot.grower(recipe).fingerprint(patch.all()), own);
  bald_spot.skin[0].centre = {9, 9, 9};  // touches no fur
  EXPECT_EQ(bald_spot.grower(recipe).fingerprint(patch.all()), own);
}

TEST(GrowExtremes, StrandsAreFiniteOrAbsent) {
  const GrowRecipe recipe{Coat{.count = 300}};
  for (const float length : {0.0f, 1e-6f, 0.001f, 10.0f}) {
    FurPatch patch(0.2, 2, length);
    for (std::size_t v = 0; v < patch.direction.size(); ++v) patch.direction[v] = {v % 2 ? 1.0f : -1.0f, 0};
    const StrandSet set = patch.grow(recipe);
    if (length < 1e-5f) {
      EXPECT_LE(set.count(), 1u);
    }
    for (const StrandPoint& point : set.points) {
      ASSERT_TRUE(std::isfinite(glm::dot(point.position, point.position)));
      ASSERT_GE(point.radius, 1e-7f);
      ASSERT_LE(glm::length(point.position), 2 * length + 0.3f);
    }
  }
}

TEST(GrowExtremes, NothingGrowsWithoutDensityOrSkin) {
  const GrowRecipe recipe{Coat{.count = 300}};
  FurPatch patch(0.2, 2);
  const std::vector<float> none(patch.positions.size(), 0.0f);
  patch.paint.density = none;
  EXPECT_EQ(patch.grow(recipe).count(), 0u);
  const Grower empty(FurModel{}, FurFields{}, recipe);
  EXPECT_EQ(expected_strands(FurModel{}, recipe.coat), 0);
  EXPECT_EQ(empty.grow({}).count(), 0u);
  FurPatch flat(0.2, 1);
  flat.triangles[0] = {0, 0, 1};
  for (auto& corners : flat.corners) corners[1].tile_uv = corners[0].tile_uv;  // repeats one vertex
  EXPECT_EQ(flat.grow(recipe).count(), 0u);
  EXPECT_EQ(expected_strands(flat.model(), recipe.coat), 0);
}

TEST(GrowExtremes, StrandsWithoutWidthHaveTheLeastRadius) {
  Coat coat = plain_coat(200);
  coat.width_root = coat.width_tip = 0;
  const StrandSet set = FurPatch(0.2).grow({coat});
  EXPECT_GT(set.count(), 0u);
  for (const StrandPoint& point : set.points) ASSERT_EQ(point.radius, 1e-7f);
}

TEST(GrowExtremes, AHugeTriangleStopsAtItsLimit) {
  Coat coat = plain_coat(100000);
  coat.tile = 0.01;
  std::vector<TileCopy> found;
  const TileCells cells(make_strands(coat), coat.tile);
  cells.find({{{-90, -90}, {90, -90}, {0, 90}}}, found);
  EXPECT_EQ(found.size(), TileCells::max_copies);
  cells.find({{{-90, -90}, {90, 90}, {90, 90 + 1e-9}}}, found);  // a very thin triangle
  EXPECT_LT(found.size(), 20000u);
  for (const double far : {1e30, static_cast<double>(INFINITY), static_cast<double>(NAN)}) {
    cells.find({{{0, 0}, {far, 0}, {0, 1}}}, found);
    EXPECT_TRUE(found.empty());
  }
}

}  // namespace
}  // namespace pelage
