#include "renderer/strands/strand_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

TEST(StrandColour, KeepsDarkAndBrightColours) {
  for (const glm::vec3 colour : {glm::vec3(0), glm::vec3(1), glm::vec3(0.001f, 0.02f, 0.3f), glm::vec3(0.9f, 2, 4)}) {
    const glm::vec3 back = unpack_colour(pack_colour(colour));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], colour[k], 0.002f * std::sqrt(colour[k]) + 4e-6f) << colour[k];
  }
  EXPECT_EQ(unpack_colour(pack_colour({9, -1, 0})), glm::vec3(4, 0, 0));
}

}  // namespace
}  // namespace pelage
