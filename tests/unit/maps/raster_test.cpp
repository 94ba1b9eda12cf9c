// Drawing, dilating, fitting and sampling of maps, against plain reference implementations.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "server/maps/encoding.h"
#include "server/maps/read_map.h"

namespace pelage {
namespace {

/// Triangles in texture space that share no corners.
UvCorners loose_triangles(const std::vector<std::array<glm::vec2, 3>>& triangles) {
  UvCorners uvs;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(uvs.corners.size());
    for (const glm::vec2 uv : triangle) uvs.corners.push_back({0, uv, {1, 0}, 1, true});
    uvs.of_triangle.emplace_back(first, first + 1, first + 2);
  }
  return uvs;
}

UvCorners random_triangles(std::uint64_t seed, int count, double low, double high) {
  Random random(seed);
  std::vector<std::array<glm::vec2, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    auto& triangle = triangles.emplace_back();
    for (glm::vec2& uv : triangle) uv = glm::vec2(random.uniform(low, high), random.uniform(low, high));
  }
  return loose_triangles(triangles);
}

std::vector<glm::vec4> random_values(std::uint64_t seed, std::size_t count) {
  Random random(seed, 1);
  std::vector<glm::vec4> values;
  for (std::size_t i = 0; i < count; ++i)
    values.emplace_back(random.uniform(), random.uniform(), random.uniform(), random.uniform());
  return values;
}

/// Value of a pixel: that of the last triangle which contains its centre, by barycentric coordinates. Returns false if
/// none does.
bool plain_pixel(const UvCorners& uvs, const std::vector<glm::vec4>& values, int size, int x, int y,
                 glm::dvec4& value) {
  bool found = false;
  for (std::size_t i = 0; i < 9 * uvs.of_triangle.size(); ++i) {
    const glm::uvec3 t = uvs.of_triangle[i / 9];  // each triangle in nine shifted copies, since the picture repeats
    const double u = (x + 0.5) / size + static_cast<double>(i % 3) - 1;
    const double v = 1 - (y + 0.5) / size + static_cast<double>(i / 3 % 3) - 1;
    const glm::dvec2 a(uvs.corners[t.x].uv), b(uvs.corners[t.y].uv), c(uvs.corners[t.z].uv);
    const double whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const double wb = ((u - a.x) * (c.y - a.y) - (c.x - a.x) * (v - a.y)) / whole;
    const double wc = ((b.x - a.x) * (v - a.y) - (u - a.x) * (b.y - a.y)) / whole;
    if (wb < 0 || wc < 0 || wb + wc > 1) continue;
    value = (1 - wb - wc) * glm::dvec4(values[t.x]) + wb * glm::dvec4(values[t.y]) + wc * glm::dvec4(values[t.z]);
    found = true;
  }
  return found;
}

double bilinear(const MapImage& image, glm::vec2 uv, int channel) {
  const Taps taps = taps_at(uv, image.size, image.size);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += taps.weights[i] * image.at(taps.pixels[i])[channel];
  return sum;
}

TEST(MapRaster, DrawsWhatAPlainRasteriserDraws) {
  for (const int size : {1, 2, 17, 96}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const UvCorners uvs = random_triangles(seed, 12, -0.2, 1.2);
      const std::vector<glm::vec4> values = random_values(seed, uvs.corners.size());
      MapImage image = make_map_image(size, 4, glm::dvec4(-5));
      draw_triangles(uvs, values, image);
      int different = 0;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const auto pixel = static_cast<std::size_t>(y * size + x);
          glm::dvec4 wanted(-5);
          if (!plain_pixel(uvs, values, size, x, y, wanted)) continue;  // corners may still be drawn there
          ASSERT_TRUE(image.covered[pixel]);
          for (int k = 0; k < 4; ++k) different += std::abs(image.at(pixel)[k] - wanted[k]) > 1e-5;
        }
      }
      EXPECT_EQ(different, 0) << size << " " << seed;
    }
  }
}

TEST(MapRaster, OverlapsShowTheLastTriangle) {
  const std::array<glm::vec2, 3> one{{{0, 0}, {1, 0}, {0, 1}}};
  const UvCorners uvs = loose_triangles({one, one});
  std::vector<glm::vec4> values(3, glm::vec4(1));
  values.resize(6, glm::vec4(2));
  MapImage image = make_map_image(8, 1, glm::dvec4(0));
  draw_triangles(uvs, values, image);
  EXPECT_EQ(image.at(7 * 8)[0], 2.0f);
  EXPECT_EQ(image.at(7)[0], 0.0f) << "the other half is background";
}

TEST(MapRaster, TrianglesWithoutAreaPutTheirCorners) {
  const UvCorners uvs = loose_triangles({{{{0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}}}, {{{1, 1}, {1, 1}, {1, 1}}}});
  MapImage image = make_map_image(10, 1, glm::dvec4(0));
  draw_triangles(uvs, std::vector<glm::vec4>(6, glm::vec4(3)), image);
  EXPECT_EQ(std::count(image.covered.begin(), image.covered.end(), 1), 2);
  EXPECT_EQ(image.at(6 * 10 + 3)[0], 3.0f);
  EXPECT_EQ(image.at(9)[0], 3.0f);
}

TEST(MapDilation, TakesTheNearestCoveredPixel) {
  for (const int distance : {0, 1, 3, 8, 64}) {
    const int size = 40;
    MapImage image = make_map_image(size, 1, glm::dvec4(-1));
    Random random(static_cast<std::uint64_t>(distance));
    for (int i = 0; i < 12; ++i) {
      const auto pixel = static_cast<std::size_t>(random.uniform() * size * size);
      image.at(pixel)[0] = static_cast<float>(i), image.covered[pixel] = 1;
    }
    const MapImage before = image;
    dilate(image, distance);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        double nearest = std::numeric_limits<double>::infinity(), found = nearest;
        const auto here = static_cast<std::size_t>(y * size + x);
        for (int p = 0; p < size * size; ++p) {
          if (!before.covered[static_cast<std::size_t>(p)]) continue;
          const double far = std::hypot(p % size - x, p / size - y);
          nearest = std::min(nearest, far);
          if (before.at(static_cast<std::size_t>(p))[0] == image.at(here)[0]) found = std::min(found, far);
        }
        if (nearest <= distance)
          ASSERT_EQ(found, nearest) << x << " " << y << " " << distance;
        else
          ASSERT_EQ(image.at(here)[0], -1.0f);
        ASSERT_EQ(image.covered[here] != 0, nearest <= distance);
      }
    }
  }
}

/// Largest error of a bilinear lookup along the borders of two islands that hold 1.
double worst_on_seams(int distance) {
  const UvCorners uvs =
      loose_triangles({{{{0.1f, 0.1f}, {0.8f, 0.2f}, {0.3f, 0.7f}}}, {{{0.9f, 0.9f}, {0.45f, 0.8f}, {0.85f, 0.4f}}}});
  MapImage image = make_map_image(64, 1, glm::dvec4(0));
  draw_triangles(uvs, std::vector<glm::vec4>(6, glm::vec4(1)), image);
  dilate(image, distance);
  double worst = 0;
  for (const glm::uvec3 t : uvs.of_triangle) {
    for (int k = 0; k < 3; ++k) {
      for (int step = 0; step <= 20; ++step) {
        const glm::vec2 uv =
            glm::mix(uvs.corners[t[k]].uv, uvs.corners[t[(k + 1) % 3]].uv, static_cast<float>(step) / 20);
        worst = std::max(worst, std::abs(bilinear(image, uv, 0) - 1));
      }
    }
  }
  return worst;
}

TEST(MapDilation, BilinearReadersSeeNoSeam) {
  EXPECT_GT(worst_on_seams(0), 0.4) << "without it they do";
  EXPECT_LT(worst_on_seams(2), 1e-6);
}

TEST(MapFit, BilinearReadersFindTheCorners) {
  std::vector<std::array<glm::vec2, 3>> grid;
  const int cells = 9;
  Random random(3);
  std::vector<glm::vec2> coordinates;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const glm::dvec2 inside(i > 0 && i < cells ? random.uniform(-0.2, 0.2) : 0,
                              j > 0 && j < cells ? random.uniform(-0.2, 0.2) : 0);
      coordinates.emplace_back((glm::dvec2(i, j) + inside) / double(cells));
    }
  }
  UvCorners uvs;
  for (const glm::vec2 uv : coordinates) uvs.corners.push_back({0, uv, {1, 0}, 1, true});
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i;
      uvs.of_triangle.emplace_back(a, a + 1, a + cells + 2),
          uvs.of_triangle.emplace_back(a, a + cells + 2, a + cells + 1);
    }
  }
  const std::vector<glm::vec4> values = random_values(4, coordinates.size());
  const auto worst = [&](bool fitted) {
    MapImage image = make_map_image(100, 4, glm::dvec4(0));
    draw_triangles(uvs, values, image);
    dilate(image, 2);
    if (fitted) fit_corners(uvs, values, glm::dvec4(0), glm::dvec4(1), image);
    double miss = 0;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      for (int k = 0; k < 4; ++k) miss = std::max(miss, std::abs(bilinear(image, coordinates[i], k) - values[i][k]));
    }
    for (const float value : image.values) EXPECT_TRUE(value >= 0 && value <= 1) << value;
    return miss;
  };
  EXPECT_GT(worst(false), 1e-3);
  EXPECT_LT(worst(true), 1e-5);
}

TEST(MapTaps, RepeatOutsideAndHoldTheEdges) {
  MapImage image = make_map_image(4, 1, glm::dvec4(0));
  for (std::size_t i = 0; i < 16; ++i) image.values[i] = static_cast<float>(i % 4);
  EXPECT_DOUBLE_EQ(bilinear(image, {0, 0.5f}, 0), 0);
  EXPECT_DOUBLE_EQ(bilinear(image, {1, 0.5f}, 0), 3);
  EXPECT_DOUBLE_EQ(bilinear(image, {0.5f, 0.5f}, 0), 1.5);
  EXPECT_DOUBLE_EQ(bilinear(image, {1.5f, -7.5f}, 0), 1.5);
  EXPECT_TRUE(std::isfinite(bilinear(image, {1e6f, -1e6f}, 0)));
}

TEST(MapTaps, CountsTrianglesOutside) {
  EXPECT_EQ(count_outside(loose_triangles({{{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {1.5f, 0}, {0, 1}}}})), 1u);
}

TEST(Udim, ATileHasItsOwnTrianglesAloneAndAllOfItsSquare) {
  UvCorners uvs = loose_triangles({{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 1}, {2, 1}, {1, 2}}}, {{{1, 0}, {2, 0}, {2, 1}}}});
  uvs.first = {0, static_cast<std::uint32_t>(uvs.corners.size())};
  EXPECT_EQ(udims_of(uvs), (std::vector<int>{1001, 1002, 1012}));
  const UvCorners inside = in_udim(uvs, 1012);
  ASSERT_EQ(inside.of_triangle.size(), 1u);
  ASSERT_EQ(inside.corners.size(), 3u);
  EXPECT_EQ(inside.of_vertex(0).size(), 3u);
  EXPECT_EQ(inside.corners[inside.of_triangle[0].x].uv, glm::vec2(0, 0));
  EXPECT_EQ(inside.corners[inside.of_triangle[0].y].uv, glm::vec2(1, 0)) << "the far side, and not the near one";
  EXPECT_EQ(inside.corners[inside.of_triangle[0].z].uv, glm::vec2(0, 1));
  EXPECT_EQ(in_udim(uvs, 0).of_triangle.size(), 3u);
  EXPECT_TRUE(in_udim(uvs, 1003).of_triangle.empty());
}

}  // namespace
}  // namespace pelage
