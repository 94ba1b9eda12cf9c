#include "renderer/pattern/tufts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

constexpr glm::vec3 up{0, 1, 0};

TEST(Tufts, PullsLieAlongTheSurfaceAndAreBounded) {
  for (const int scales : {1, 2, 3}) {
    const Tufts tufts{.gather = 1, .size = 0.1, .scales = scales};
    float inside_sum = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::vec3 root(0.017f * static_cast<float>(i % 50), 0.3f, 0.013f * static_cast<float>(i / 50));
      const TuftPull tuft = tuft_at(tufts, root, up);
      EXPECT_NEAR(tuft.to_middle.y, 0, 1e-6f);
      EXPECT_LE(glm::length(tuft.to_middle), longest_pull(tufts) * 1.0001f);
      EXPECT_GE(tuft.inside, 0);
      EXPECT_LE(tuft.inside, 1);
      inside_sum += tuft.inside;
    }
    EXPECT_GT(inside_sum / 2000, 0.1f);
    EXPECT_LT(inside_sum / 2000, 0.7f);
  }
}

TEST(Tufts, RootsGatherAboutOneMiddle) {
  const Tufts tufts{.gather = 1, .size = 0.2, .scales = 1};
  int together = 0, pairs = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 root(0.031f * static_cast<float>(i % 25), 0, 0.029f * static_cast<float>(i / 25)),
        next = root + glm::vec3(0.002f, 0, 0);
    const TuftPull a = tuft_at(tufts, root, up), b = tuft_at(tufts, next, up);
    ++pairs;
    if (glm::distance(root + a.to_middle, next + b.to_middle) < 1e-4f) ++together;
  }
  EXPECT_GT(together, pairs * 9 / 10);  // the other pairs are on two sides of a border
  EXPECT_LT(together, pairs);
}

TEST(Tufts, InsideFallsToNothingOnTheBorder) {
  const Tufts tufts{.gather = 1, .size = 0.2, .scales = 1};
  TuftPull last = tuft_at(tufts, {0, 0, 0}, up);
  int borders = 0;
  for (float x = 0.0005f; x < 2; x += 0.0005f) {
    const TuftPull next = tuft_at(tufts, {x, 0, 0}, up);
    if (glm::distance(last.to_middle, next.to_middle) > 0.01f) {
      ++borders;
      EXPECT_LT(std::min(last.inside, next.inside), 0.02f) << x;
    }
    last = next;
  }
  EXPECT_GT(borders, 5);
}

TEST(Tufts, NothingGathersAtTheRoot) {
  const Tufts tufts{.gather = 1};
  EXPECT_EQ(gathered(tufts, 0), 0);
  EXPECT_NEAR(gathered(tufts, 1), 0.6f, 1e-6f);
  EXPECT_EQ(gathered({.gather = 0}, 1), 0);
  for (float s = 0; s < 1; s += 0.1f) EXPECT_LT(gathered(tufts, s), gathered(tufts, s + 0.1f));
}

TEST(Tufts, SeedsAndScalesChangeThem) {
  const glm::vec3 root(0.1f, 0.2f, 0.3f);
  const auto to_middle = [&](const Tufts& tufts) { return tuft_at(tufts, root, up).to_middle; };
  EXPECT_EQ(to_middle({.gather = 1}), to_middle({.gather = 0.5}));
  EXPECT_NE(to_middle({.seed = 1}), to_middle({.seed = 2}));
  EXPECT_NE(to_middle({.scales = 1}), to_middle({.scales = 2}));
}

}  // namespace
}  // namespace pelage
