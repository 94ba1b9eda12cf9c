// The order in which strands are kept when they are thinned.
#include "renderer/strands/even_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace pelage {
namespace {

std::vector<glm::vec3> scattered(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-0.4f, 0.4f);
  std::vector<glm::vec3> roots;
  for (std::size_t i = 0; i < count; ++i) roots.emplace_back(uniform(random), uniform(random), 0);
  return roots;
}

TEST(EvenOrder, HasEachOnce) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 64u, 1000u}) {
    std::vector<std::uint32_t> order = even_order(scattered(count)).order;
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, all);
  }
}

TEST(EvenOrder, AnyFirstPartLiesEvenly) {
  std::vector<glm::vec3> line;
  for (int i = 0; i < 1000; ++i) line.emplace_back(-0.5f + 0.001f * static_cast<float>(i), 0, 0);
  const EvenOrder even = even_order(line);
  for (const std::size_t part : {10u, 37u, 100u, 333u, 900u}) {
    std::vector<std::uint32_t> kept(even.order.begin(), even.order.begin() + static_cast<std::ptrdiff_t>(part));
    std::sort(kept.begin(), kept.end());
    std::uint32_t widest = 1000 - kept.back();
    for (std::size_t i = 1; i < part; ++i) widest = std::max(widest, kept[i] - kept[i - 1]);
    EXPECT_LE(widest * part, 2100u) << part;  // twice the mean gap
  }
}

TEST(EvenOrder, NeighboursCameBeforeAndLieNear) {
  const std::vector<glm::vec3> roots = scattered(4000);
  const EvenOrder even = even_order(roots);
  double to_neighbour = 0, to_any = 0;
  for (std::size_t i = 1; i < roots.size(); ++i) {
    ASSERT_LT(even.neighbour[i], i);
    const glm::vec3 own = roots[even.order[i]];
    to_neighbour += double{glm::distance(own, roots[even.order[even.neighbour[i]]])};
    to_any += double{glm::distance(own, roots[even.order[i * 7919 % roots.size()]])};
  }
  EXPECT_LT(to_neighbour, 0.1 * to_any);
}

}  // namespace
}  // namespace pelage
