#include "renderer/visibility/fur_work.h"

#include <gtest/gtest.h>

#include <vector>

namespace pelage {
namespace {

/// A triangle in the middle of the left half of the picture, seen from in front: an eighth of the picture.
struct OneTriangle {
  std::vector<glm::uvec3> triangles{{0, 1, 2}};
  std::vector<glm::vec3> positions{{-1, -0.5f, 0}, {0, -0.5f, 0}, {0, 0.5f, 0}};
  std::vector<glm::vec3> centroids{{-1 / 3.0f, -1 / 6.0f, 0}}, normals{{0, 0, 1}};
  std::vector<float> lengths{0, 0, 0}, levels{0, 0, 0};
  ShellView view{.viewpoint = {0, 0, 10}, .pixel = 0.01f, .shells = 8, .policy = ShellPolicy::uniform};

  FurWork work(int side) const {
    const std::vector<CellBox> cells = cells_of_fur(view.to_clip, positions, lengths);
    return FurWork({triangles, centroids, normals, positions, lengths, levels, cells}, view, {side, side});
  }
};

const glm::dvec2 low{0}, high{1};

TEST(FurWork, IsShellsTimesPixels) {
  OneTriangle one;
  const double small = one.work(100).in(low, high), large = one.work(1000).in(low, high);
  EXPECT_NEAR(large - small, 8 * (1000.0 * 1000 - 100.0 * 100) / 8, 1e-3 * large);
  one.view.shells = 32;
  EXPECT_NEAR(one.work(1000).in(low, high), 4 * large, 1e-9 * large);
}

TEST(FurWork, LiesWhereTheFurIs) {
  const FurWork work = OneTriangle().work(1000);
  const double all = work.in(low, high);
  EXPECT_EQ(work.in({0.55, 0}, high), 0);
  EXPECT_EQ(work.in({0, 0.8}, high), 0);
  EXPECT_NEAR(work.in({0, 0.2}, {0.53, 0.8}), all, 1e-9 * all);
}

TEST(FurWork, OfPartsSumsToTheWhole) {
  const FurWork work = OneTriangle().work(1000);
  double sum = 0;
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 5; ++x)
      sum += work.in(glm::dvec2(x, y) / glm::dvec2(5, 7), glm::dvec2(x + 1, y + 1) / glm::dvec2(5, 7));
  }
  EXPECT_NEAR(sum, work.in(low, high), 1e-6 * sum);
  EXPECT_EQ(FurWork().in(low, high), 0);
}

}  // namespace
}  // namespace pelage
