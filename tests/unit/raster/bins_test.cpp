// Segments binned by tile, and their order.
#include "renderer/raster/bins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace pelage {
namespace {

constexpr PixelBox box{0, 0, 64, 48};

PlacedStrands one_strand(const std::vector<PlacedKnot>& knots) {
  return {knots, std::vector<float>(knots.size()), {0, static_cast<std::uint32_t>(knots.size())}};
}

Bins binned(const std::vector<PlacedStrands>& batches, const std::vector<float>& furthest = std::vector<float>(12)) {
  Bins bins;
  bins.begin(box, batches.size());
  for (std::size_t i = batches.size(); i-- > 0;) bins.find(i, batches[i], furthest, {0.25f, 2});
  bins.allocate_entries();
  for (std::size_t i = batches.size(); i-- > 0;) bins.put(i);
  return bins;
}

TEST(Bins, HaveASegmentInEachTileThatItTouches) {
  const Bins bins = binned({one_strand({{8, 8, 1, 0.5f, {}}, {56, 40, 1, 0.5f, {}}})});
  std::size_t found = 0;
  for (int tile = 0; tile < 12; ++tile) found += bins.tile(tile).size();
  EXPECT_EQ(bins.tile(0).size(), 1u);
  EXPECT_EQ(bins.tile(5).size(), 1u);  // halfway along the segment
  EXPECT_EQ(bins.tile(3).size(), 0u);  // only the segment's bounding box touches these two tiles
  EXPECT_EQ(bins.tile(8).size(), 0u);
  EXPECT_GE(found, 5u);
}

TEST(Bins, KeepTheOrderOfBatches) {
  const PlacedStrands strand = one_strand({{4, 4, 1, 0.5f, {}}, {9, 9, 1, 0.5f, {}}, {12, 12, 1, 0.5f, {}}});
  const Bins bins = binned({strand, strand});
  ASSERT_EQ(bins.tile(0).size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(bins.tile(0)[i].batch, i / 2);
    EXPECT_EQ(bins.tile(0)[i].knot, i % 2);
  }
}

/// The order of overlapping short segments must not depend on the tile; of a long one only the part near the tile
/// counts.
TEST(Bins, ShortSegmentsGoByTheirMiddleInEachTile) {
  const Bins of_short = binned({one_strand({{12, 8, 0.5f, 0.5f, {}}, {22, 8, 1, 0.5f, {}}})});
  ASSERT_EQ(of_short.tile(0).size() + of_short.tile(1).size(), 2u);
  EXPECT_EQ(of_short.tile(0)[0].key, of_short.tile(1)[0].key);
  const Bins of_long = binned({one_strand({{2, 8, 0.5f, 0.5f, {}}, {62, 8, 1, 0.5f, {}}})});
  for (int tile = 0; tile < 3; ++tile)
    EXPECT_GT(of_long.tile(tile)[0].key, of_long.tile(tile + 1)[0].key) << "nearer and nearer";
}

TEST(Bins, LeaveOutWhatIsBehindOrTooNear) {
  const std::vector<float> furthest(12, 0.5f);
  EXPECT_EQ(binned({one_strand({{8, 8, 0.4f, 1, {}}, {9, 9, 0.45f, 1, {}}})}, furthest).tile(0).size(), 0u);
  EXPECT_EQ(binned({one_strand({{8, 8, 0.4f, 1, {}}, {9, 9, 0.6f, 1, {}}})}, furthest).tile(0).size(), 1u);
  EXPECT_EQ(binned({one_strand({{8, 8, 0, 1, {}}, {9, 9, 0.6f, 1, {}}})}, furthest).tile(0).size(), 0u);
}

TEST(Bins, HoldNumbersOfAnySize) {
  constexpr float huge = 1e30f, infinite = std::numeric_limits<float>::infinity(),
                  none = std::numeric_limits<float>::quiet_NaN();
  for (const float x : {-huge, huge, infinite, -infinite, none, 1e6f}) {
    const Bins bins =
        binned({one_strand({{8, 8, 1, 1, {}}, {x, 20, 1, 1, {}}}), one_strand({{x, x, 1, x, {}}, {x, x, 1, 1, {}}})});
    for (int tile = 0; tile < 12; ++tile) EXPECT_LE(bins.tile(tile).size(), 2u);
  }
}

TEST(DistanceKeys, GoByDistanceInStepsOfItsShare) {
  for (const auto& [far, near] : {std::pair(0.4f, 0.7f), std::pair(0.01f, 1e4f)}) {
    const DistanceKeys keys(far, near);
    const double octaves = std::log2(double{near} / double{far});
    std::uint32_t before = keys.of(near);
    for (double at = 0; at < 1; at += 0.001) {
      const auto inverse = static_cast<float>(double{near} * std::pow(double{far} / double{near}, at));
      ASSERT_GE(keys.of(inverse), before);
      before = keys.of(inverse);
      ASSERT_LT(keys.of(inverse), DistanceKeys::end);
      const auto further = static_cast<float>(double{inverse} * (1 - octaves * 2e-4));
      ASSERT_LT(keys.of(inverse), keys.of(further)) << far;
    }
    EXPECT_LE(keys.of(2 * near), keys.of(near)) << "nearer than all";
    EXPECT_EQ(keys.of(far / 2), DistanceKeys::end - 1);
  }
}

TEST(Bins, SortNearestFirstAndStable) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0.5f, 2);
  const DistanceKeys keys(0.5f, 2);
  std::vector<BinEntry> entries, sorted, room;
  for (std::uint32_t i = 0; i < 5000; ++i) entries.push_back({0, i, keys.of(i % 3 ? uniform(random) : 1.0f)});
  sort_by_distance(entries, sorted, room);
  ASSERT_EQ(sorted.size(), entries.size());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    EXPECT_LE(sorted[i - 1].key, sorted[i].key);
    if (sorted[i - 1].key == sorted[i].key) {
      EXPECT_LT(sorted[i - 1].knot, sorted[i].knot);
    }
  }
}

}  // namespace
}  // namespace pelage
