#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "renderer/strands/tile_strands.h"

namespace pelage {
namespace {

/// Strands on an 8 x 8 lattice over a tile of side 1: many lie exactly on edges and corners.
std::vector<Strand> lattice() {
  std::vector<Strand> strands(64);
  for (std::size_t i = 0; i < strands.size(); ++i) strands[i].root = glm::dvec2(i % 8, i / 8) / 8.0;
  return strands;
}

using Times = std::map<std::tuple<std::uint32_t, int, int>, int>;

/// Counts how often each copy is found in the triangles of a fan around `middle`.
Times found_in_fan(glm::dvec2 middle, std::vector<glm::dvec2> around, bool clockwise) {
  const std::vector<Strand> strands = lattice();
  const TileCells cells(strands, 1);
  Times times;
  std::vector<TileCopy> found;
  for (std::size_t i = 0; i < around.size(); ++i) {
    glm::dvec2 a = around[i], b = around[(i + 1) % around.size()];
    if (clockwise) std::swap(a, b);
    cells.find({middle, a, b}, found);
    for (const TileCopy& copy : found) ++times[{copy.strand, copy.tiles.x, copy.tiles.y}];
  }
  return times;
}

TEST(TileCells, CopiesOnSharedEdgesFallIntoOneTriangle) {
  const std::vector<glm::dvec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const bool clockwise : {false, true}) {
    for (const glm::dvec2 middle : {glm::dvec2(0, 0), glm::dvec2(0.25, -0.5), glm::dvec2(0.1, 0.3)}) {
      const Times times = found_in_fan(middle, square, clockwise);
      EXPECT_EQ(times.size(), 256u);  // 16 x 16: the square is half open too
      EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](const auto& one) { return one.second == 1; }));
    }
  }
}

TEST(TileCells, ShareLeadsBackToThePosition) {
  const std::vector<Strand> strands = lattice();
  const std::array<glm::dvec2, 3> triangle{{{-2.2, 0.3}, {-0.7, -1.9}, {0.4, 0.8}}};
  std::vector<TileCopy> found;
  TileCells(strands, 1).find(triangle, found);
  EXPECT_NEAR(static_cast<double>(found.size()), 64 * 3.235, 10);
  for (const TileCopy& copy : found) {
    const glm::dvec2 back = copy.share.x * triangle[0] + copy.share.y * triangle[1] + copy.share.z * triangle[2];
    EXPECT_LT(glm::distance(back, strands[copy.strand].root + glm::dvec2(copy.tiles)), 1e-12);
  }
}

TEST(TileCells, NoneWithoutAnArea) {
  std::vector<TileCopy> found;
  const TileCells cells(lattice(), 1);
  cells.find({{{0, 0}, {1, 1}, {2, 2}}}, found);
  EXPECT_TRUE(found.empty());
  cells.find({{{0, 0}, {0, 0}, {1, 0}}}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace pelage
