#include <gtest/gtest.h>

#include "renderer/coat/slices.h"

namespace pelage {
namespace {

Coat ramp(glm::vec3 root, glm::vec3 tip) {
  Coat coat;
  coat.ramp = {{0.0, root}, {1.0, tip}};
  return coat;
}

TEST(ColourAbove, IsOneOnARampOfOneColour) {
  for (const glm::vec3& ratio : colour_above(ramp({0.2f, 0.4f, 0.6f}, {0.2f, 0.4f, 0.6f}))) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ratio[k], 1, 1e-5);
  }
}

TEST(ColourAbove, IsTheMeanUpToTheTipOverTheColourThere) {
  const auto above = colour_above(ramp({0.1f, 0.5f, 0.5f}, {0.9f, 0.5f, 0.1f}));
  EXPECT_NEAR(above.front().r, 0.5 / 0.1125, 0.02);  // the middle of the first slice is at 1/64
  EXPECT_NEAR(above.front().g, 1, 1e-5);
  EXPECT_LT(above.front().b, 1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(above.back()[k], 1, 1e-5);
}

TEST(ColourAbove, StaysFiniteOverBlack) {
  for (const glm::vec3& ratio : colour_above(ramp({0, 0, 0}, {1, 1, 0}))) {
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(ratio[k] >= 0 && ratio[k] <= 100);
  }
}

}  // namespace
}  // namespace pelage
