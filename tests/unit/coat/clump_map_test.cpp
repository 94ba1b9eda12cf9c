#include <gtest/gtest.h>

#include <glm/glm.hpp>

#include "renderer/coat/strand_tile.h"

namespace pelage {
namespace {

struct Texel {
  glm::dvec2 to_middle;  // vector to the clump's middle, in tiles
  double inside;
};

Texel texel_at(const ClumpMap& map, int x, int y) {
  const std::size_t i = 4 * static_cast<std::size_t>(y * ClumpMap::side + x);
  return {(glm::dvec2(map.texels[i], map.texels[i + 1]) / 127.5 - 1.0) * map.reach, map.texels[i + 2] / 255.0};
}

TEST(ClumpMap, LeadsToTheMiddlesOfTheCoatsClumps) {
  for (const double size : {0.006, 0.02, 0.1}) {
    Coat coat;
    coat.clump_size = size;
    const ClumpMap map = bake_clump_map(coat);
    const ClumpGrid clumps(coat.tile, coat.clump_size, coat.seed, 1);
    ASSERT_EQ(map.texels.size(), 4u * ClumpMap::side * ClumpMap::side);
    for (int i = 0; i < 500; ++i) {
      const glm::ivec2 at(i * 37 % ClumpMap::side, i * 101 % ClumpMap::side);
      const glm::dvec2 position = (glm::dvec2(at) + 0.5) / double(ClumpMap::side);
      const glm::dvec2 middle = clumps.nearest(position * coat.tile).centre / coat.tile;
      EXPECT_LT(glm::distance(position + texel_at(map, at.x, at.y).to_middle, middle), 0.01 * map.reach);
    }
  }
}

TEST(ClumpMap, InsideIsOneInTheMiddleAndZeroOnTheBorder) {
  const ClumpMap map = bake_clump_map({});
  double max = 0, min = 1;
  for (int y = 0; y < ClumpMap::side; ++y) {
    for (int x = 0; x < ClumpMap::side; ++x) {
      const Texel here = texel_at(map, x, y), next = texel_at(map, (x + 1) % ClumpMap::side, y);
      max = std::max(max, here.inside), min = std::min(min, here.inside);
      const double step = 1.0 / ClumpMap::side;
      const bool other_clump = std::abs(next.to_middle.x + step - here.to_middle.x) > 2 * step;
      if (other_clump) {
        EXPECT_LT(here.inside * glm::length(here.to_middle), 1.5 * step + 0.01 * map.reach) << x << " " << y;
      }
    }
  }
  EXPECT_GT(max, 0.9);
  EXPECT_LT(min, 0.05);
}

TEST(ClumpMap, BakesExtremeTilesAndClumps) {
  for (const auto& [tile, size] : {std::pair{0.01, 0.5}, {1.0, 0.001}, {0.12, 0.5}}) {
    Coat coat;
    coat.tile = tile, coat.clump_size = size;
    const ClumpMap map = bake_clump_map(coat);
    EXPECT_GT(map.reach, 0);
    EXPECT_LE(map.reach, 1);
  }
}

}  // namespace
}  // namespace pelage
