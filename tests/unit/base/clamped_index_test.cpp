#include "base/clamped_index.h"

#include <gtest/gtest.h>

#include <limits>

namespace pelage {
namespace {

TEST(ClampedIndex, IsTheWholePartWithinItsRange) {
  EXPECT_EQ(clamped_index(7.9f, 0, 10), 7);
  EXPECT_EQ(clamped_index(0.0, 0, 10), 0);
  EXPECT_EQ(clamped_index(10.0, 0, 10), 10);
}

TEST(ClampedIndex, ClampsWhatIntCannotHold) {
  for (const float large : {1e10f, 1e30f, std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(clamped_index(large, 0, 255), 255);
    EXPECT_EQ(clamped_index(-large, 0, 255), 0);
    EXPECT_EQ(clamped_index(large, 0, std::numeric_limits<int>::max()), std::numeric_limits<int>::max());
  }
  EXPECT_EQ(clamped_index(-1e300, -3, 3), -3);
}

TEST(ClampedIndex, NanGivesTheLowest) { EXPECT_EQ(clamped_index(std::numeric_limits<double>::quiet_NaN(), 2, 9), 2); }

}  // namespace
}  // namespace pelage
