// The building blocks of the models without a fibre.
#include "tests/double_shading/empirical.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

namespace pelage {
namespace {

TEST(SinePower, KeepsItsDigitsWherePowDoesNot) {
  double naive = 0, ours = 0;
  for (const float n : {1e3f, 1e6f}) {
    for (int i = 0; i < 2000; ++i) {
      const float d = static_cast<float>(i) * 2e-6f * (n < 1e4f ? 40.0f : 1.0f);
      const double truth = std::exp(0.5 * double(n) * std::log1p(-double(d) * double(d)));
      naive = std::max(naive, std::abs(double(std::pow(std::sqrt(1 - d * d), n)) - truth));
      ours = std::max(ours, std::abs(double(sine_power(d, n)) - truth));
    }
  }
  EXPECT_GT(naive, 1e-2);
  EXPECT_LT(ours, 1.5e-7);
}

/// science.md 4: pow is off by 4.5e-5 at n = 1e3 and by 4e-2 at 1e6; the exponential's error stays below 1e-7.
TEST(SinePower, PowIsOffByWhatScienceSays) {
  const auto largest_error = [](float n, bool naive) {
    double largest = 0;
    for (int i = 0; i < 20000; ++i) {
      const float d = 5 / std::sqrt(n) * static_cast<float>(i) / 20000;
      const double truth = std::exp(0.5 * double(n) * std::log1p(-double(d) * double(d)));
      const float value = naive ? std::pow(std::sqrt(1 - d * d), n) : sine_power(d, n);
      largest = std::max(largest, std::abs(double(value) - truth));
    }
    return largest;
  };
  EXPECT_NEAR(largest_error(1e3f, true), 4.5e-5, 1e-5);
  EXPECT_NEAR(largest_error(1e6f, true), 4e-2, 1e-2);
  for (const float n : {1e3f, 1e6f}) EXPECT_LT(largest_error(n, false), 1.2e-7) << n;
}

/// science.md 4: with T = H, 1 - d^2 is negative in float for a quarter of unit vectors.
TEST(SinePower, OfADirectionWithItselfIsNothing) {
  Random random(3);
  int below = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 any(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const glm::vec3 unit = any / glm::length(any);
    const float d = glm::dot(unit, unit);
    below += 1 - d * d < 0;
    EXPECT_LT(sine_power(d, 2.0f), 1e-6f);
    EXPECT_GE(sine_power(d, 0.5f), 0);
  }
  EXPECT_GT(below, 0.15 * count);
  EXPECT_LT(below, 0.35 * count);
}

TEST(SinePower, IsExactAtTheEnds) {
  EXPECT_EQ(sine_power(1.0, 0.0), 1);
  EXPECT_EQ(sine_power(1.0, 1e6), 0);
  EXPECT_EQ(sine_power(1.0000001, 3.0), 0);
  EXPECT_EQ(sine_power(0.0, 1e6), 1);
  EXPECT_EQ(sine_power(0.3, 0.0), 1);
}

TEST(LightBehind, FallsOverItsReachForSurfacesAlone) {
  EXPECT_EQ(backlight_fade(ShadingModel::kajiya, 0.2, 0.5), 1);
  EXPECT_DOUBLE_EQ(backlight_fade(ShadingModel::kajiya, -0.25, 0.5), 0.5);
  EXPECT_EQ(backlight_fade(ShadingModel::kajiya, -0.9, 0.5), 0);
  EXPECT_EQ(backlight_fade(ShadingModel::energy_conserving, -1, 0.5), 1);
  EXPECT_EQ(backlight_fade(ShadingModel::marschner, -1, 0.5), 1);
}

}  // namespace
}  // namespace pelage
