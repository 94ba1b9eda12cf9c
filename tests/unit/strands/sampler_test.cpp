#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "renderer/strands/sampling.h"

namespace pelage {
namespace {

/// Sample `index` of a pixel, its pair number `pair`.
glm::vec2 pair_of(std::uint32_t pixel, std::uint32_t index, int pair, std::uint32_t seed = 1) {
  Sampler sampler(pixel, index, seed);
  glm::vec2 result(0);
  for (int i = 0; i <= pair; ++i) result = sampler.next2();
  return result;
}

TEST(Sampler, FirstPowersOfTwoFillEveryElementaryInterval) {
  for (const std::uint32_t pixel : {0u, 7u, 409599u, 0xffffffffu}) {
    for (const int pair : {0, 1, 9}) {
      for (int k = 0; k <= 10; ++k) {
        for (int across = 0; across <= k; ++across) {  // boxes of 2^-across by 2^-(k - across)
          std::set<std::pair<int, int>> boxes;
          for (std::uint32_t i = 0; i < 1u << k; ++i) {
            const glm::vec2 u = pair_of(pixel, i, pair);
            boxes.emplace(int(std::ldexp(u.x, across)), int(std::ldexp(u.y, k - across)));
          }
          ASSERT_EQ(boxes.size(), std::size_t{1} << k) << "pixel " << pixel << " pair " << pair << " of " << across;
        }
      }
    }
  }
}

TEST(Sampler, NumbersStayBelowOneAndStayTheSame) {
  for (std::uint32_t i = 0; i < 20000; ++i) {
    Sampler sampler(i * 2654435761u, i * 40503u, i), again(i * 2654435761u, i * 40503u, i);
    for (int k = 0; k < 5; ++k) {
      const glm::vec2 u = sampler.next2();
      ASSERT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
      ASSERT_EQ(u, again.next2());
    }
    const float one = sampler.next();
    ASSERT_TRUE(one >= 0 && one < 1);
  }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = double(a.size());
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i], sb += b[i], saa += a[i] * a[i], sbb += b[i] * b[i], sab += a[i] * b[i];
  }
  return (sab / n - sa * sb / n / n) / std::sqrt((saa / n - sa * sa / n / n) * (sbb / n - sb * sb / n / n));
}

TEST(Sampler, PixelsPairsAndSeedsAreUncorrelated) {
  constexpr std::uint32_t count = 4096;
  const auto numbers = [&](std::uint32_t pixel, int pair, std::uint32_t seed) {
    std::vector<double> x;
    for (std::uint32_t i = 0; i < count; ++i) x.push_back(double(pair_of(pixel, i, pair, seed).x));
    return x;
  };
  const std::vector<double> base = numbers(5, 0, 1);
  for (int k = 1; k < 20; ++k) {
    EXPECT_LT(std::abs(correlation(base, numbers(5u + std::uint32_t(k), 0, 1))), 0.08) << k;
    EXPECT_LT(std::abs(correlation(base, numbers(5, k, 1))), 0.08) << k;
    EXPECT_LT(std::abs(correlation(base, numbers(5, 0, 1u + std::uint32_t(k)))), 0.08) << k;
  }
  // The first samples of neighbouring pixels, and the two numbers of a pair.
  std::vector<double> left, right, x, y;
  for (std::uint32_t pixel = 0; pixel < count; ++pixel) {
    left.push_back(double(pair_of(pixel, 0, 0).x)), right.push_back(double(pair_of(pixel + 1, 0, 0).x));
    x.push_back(double(pair_of(pixel, 3, 2).x)), y.push_back(double(pair_of(pixel, 3, 2).y));
  }
  EXPECT_LT(std::abs(correlation(left, right)), 0.06);
  EXPECT_LT(std::abs(correlation(x, y)), 0.06);
}

/// Root mean square error over many pixels, of a mean of exp(-x) cos(y) over `samples` samples.
double error_at(std::uint32_t samples) {
  const double truth = (1 - std::exp(-1.0)) * std::sin(1.0);
  double sum = 0;
  for (std::uint32_t pixel = 0; pixel < 100; ++pixel) {
    double mean = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const glm::dvec2 u(pair_of(pixel, i, 1));
      mean += std::exp(-u.x) * std::cos(u.y) / samples;
    }
    sum += (mean - truth) * (mean - truth);
  }
  return std::sqrt(sum / 100);
}

TEST(Sampler, ErrorOfASmoothIntegralFallsFasterThanByChance) {
  const double few = error_at(16), many = error_at(1024);
  EXPECT_LT(many / few, 0.02);  // random samples give an eighth, N^-1.5 a 512th
  EXPECT_LT(many, 1e-4);
}

}  // namespace
}  // namespace pelage
