#include <gtest/gtest.h>

#include "renderer/shells/sorted/sorted_pass.h"

namespace pelage {
namespace {

/// Counts how many areas contain each pixel.
std::vector<int> counts(const std::vector<Area>& areas, int width, int height) {
  std::vector<int> result(static_cast<std::size_t>(width * height));
  for (const Area& area : areas) {
    for (int y = area.top; y < area.top + area.height; ++y) {
      for (int x = area.left; x < area.left + area.width; ++x) ++result[static_cast<std::size_t>(y * width + x)];
    }
  }
  return result;
}

TEST(Areas, HalvesAcrossTheLongerSide) {
  EXPECT_EQ(halves({1, 2, 5, 3}), (std::vector<Area>{{1, 2, 2, 3}, {3, 2, 3, 3}}));
  EXPECT_EQ(halves({1, 2, 1, 2}), (std::vector<Area>{{1, 2, 1, 1}, {1, 3, 1, 1}}));
}

TEST(Areas, CutHoldsEachPixelOnce) {
  for (const double max : {0.5, 1.0, 7.0, 100.0, 1e9}) {
    const std::vector<Area> areas = cut({0, 0, 37, 23}, max);
    EXPECT_EQ(counts(areas, 37, 23), std::vector<int>(37 * 23, 1)) << max;
    for (const Area& area : areas) EXPECT_TRUE(area.pixels() <= max || area.pixels() == 1) << max;
  }
  EXPECT_EQ(cut({0, 0, 37, 23}, 851).size(), 1u);
}

}  // namespace
}  // namespace pelage
