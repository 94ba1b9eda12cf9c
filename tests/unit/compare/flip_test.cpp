// LDR-FLIP against its authors' implementation and against its known properties.
#include "renderer/compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/colour_space.h"
#include "renderer/compare/compare.h"
#include "tests/unit/compare/pictures.h"

namespace pelage {
namespace {

using namespace pictures;

constexpr double ppd = 67;

double mean_flip(const Image& reference, const Image& test, double pixels_per_degree = ppd) {
  const std::vector<float> map = flip_map(linear_image(reference), linear_image(test), pixels_per_degree);
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

template <class Change>
Image changed(Image image, Change change) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) change(&image.rgba[i]);
  return image;
}

/// The picture moved right by one pixel; the first column stays.
Image moved(const Image& image) {
  Image out = image;
  for (int y = 0; y < image.height; ++y) {
    auto row = out.rgba.begin() + static_cast<std::ptrdiff_t>(y) * image.width * 4;
    std::copy_backward(row, row + (image.width - 1) * 4, row + image.width * 4);
  }
  return out;
}

Image grey(int level) {
  return drawn(32, 32, [level](int, int, int) { return level; });
}

/// Reference values from the authors' program (FLIP.h 1.6, single precision) at 67 pixels per degree.
TEST(Flip, AgreesWithItsAuthorsImplementation) {
  constexpr double rounding = 5e-5;
  const Image plain = scene(96, 64);
  EXPECT_NEAR(mean_flip(noise(64, 48, 1), noise(64, 48, 100000)), 0.447823, rounding);
  EXPECT_NEAR(
      mean_flip(plain, changed(plain, [](std::uint8_t* p) { p[0] = static_cast<std::uint8_t>(p[0] * 9 / 10); })),
      0.182654, rounding);
  EXPECT_NEAR(mean_flip(plain, moved(plain)), 0.102136, rounding);
  EXPECT_NEAR(mean_flip(plain, changed(plain, [](std::uint8_t* p) { std::swap(p[0], p[2]); })), 0.582212, rounding);
  EXPECT_NEAR(mean_flip(noise(3, 2, 1), noise(3, 2, 50)), 0.946681, rounding) << "smaller than the filters";
  EXPECT_NEAR(mean_flip(grey(0), grey(255)), 0.967392, rounding);
  EXPECT_NEAR(mean_flip(drawn(8, 8, [](int, int, int k) { return k == 1 ? 255 : 0; }),
                        drawn(8, 8, [](int, int, int k) { return k == 2 ? 255 : 0; })),
              1, 1e-6)
      << "green and blue are the farthest apart";
}

/// science.md 6: one grey level of 255 is .03, four are .079.
TEST(Flip, GreyLevelsGiveThePublishedErrors) {
  EXPECT_NEAR(mean_flip(grey(128), grey(129)), 0.03, 0.001);
  EXPECT_NEAR(mean_flip(grey(128), grey(132)), 0.079, 0.001);
}

/// science.md 6: strands shifted by .1, .25, .5 and 1 pixel give about .06, .12, .19 and .30.
TEST(Flip, ShiftedStrandsGiveThePublishedErrors) {
  const Image still = strands(128, 128, 0);
  const double published[4][2] = {{0.1, 0.06}, {0.25, 0.12}, {0.5, 0.19}, {1, 0.30}};
  for (const auto& [shift, expected] : published) {
    EXPECT_NEAR(mean_flip(still, strands(128, 128, shift)), expected, 0.1 * expected) << shift;
  }
}

TEST(Flip, EqualPicturesGiveExactlyZeroAndOrderDoesNotMatter) {
  const FloatImage a = linear_image(noise(70, 131, 3)), b = linear_image(noise(70, 131, 9000));
  for (float error : flip_map(a, a, ppd)) ASSERT_EQ(error, 0.0f);
  EXPECT_EQ(flip_map(a, b, ppd), flip_map(b, a, ppd));
}

TEST(Flip, SameBitsWithAnyNumberOfThreads) {
  const FloatImage a = linear_image(noise(50, 300, 3)), b = linear_image(noise(50, 300, 9000));
  const std::vector<float> one = flip_map(a, b, ppd, 1);
  for (int threads : {2, 3, 16}) EXPECT_EQ(one, flip_map(a, b, ppd, threads)) << threads;
}

Image transposed(const Image& image) {
  return drawn(image.height, image.width, [&](int x, int y, int k) {
    return image.rgba[static_cast<std::size_t>((x * image.width + y) * 4 + k)];
  });
}

/// Tall pictures are measured in strips of rows, and wide ones with the same pixels in one strip: no seam may show.
TEST(Flip, StripsLeaveNoSeamAndAxesAreAlike) {
  const Image a = noise(40, 200, 3), b = noise(40, 200, 9000);
  const std::vector<float> tall = flip_map(linear_image(a), linear_image(b), ppd);
  const std::vector<float> wide = flip_map(linear_image(transposed(a)), linear_image(transposed(b)), ppd);
  for (std::size_t y = 0; y < 200; ++y) {
    for (std::size_t x = 0; x < 40; ++x) ASSERT_NEAR(tall[y * 40 + x], wide[x * 200 + y], 1e-6f) << x << " " << y;
  }
}

TEST(Flip, AnEdgeWeighsMoreThanTheSameDifferenceWithoutOne) {
  const Image flat = grey(100);
  const Image lifted = drawn(32, 32, [](int, int, int) { return 110; });
  const Image line = drawn(32, 32, [](int x, int, int) { return x == 16 ? 255 : 100; });
  EXPECT_LT(mean_flip(flat, lifted), 0.2);
  EXPECT_GT(flip_map(linear_image(flat), linear_image(line), ppd)[16 * 32 + 16], 0.5f);
}

TEST(Flip, FartherAwayLessIsSeen) {
  const Image a = noise(64, 64, 1), b = noise(64, 64, 777);
  EXPECT_GT(mean_flip(a, b, 20), mean_flip(a, b, 67));
  EXPECT_GT(mean_flip(a, b, 67), mean_flip(a, b, 200));
}

TEST(Flip, ExtremePicturesGiveErrorsWithinZeroAndOne) {
  for (double at : {5.0, 67.0, 1000.0}) {
    for (int level : {0, 255}) {
      for (float error :
           flip_map(linear_image(noise(17, 5, 2)),
                    linear_image(drawn(17, 5, [&](int x, int, int) { return x % 2 ? level : 255 - level; })), at)) {
        ASSERT_TRUE(error >= 0 && error <= 1) << at;
      }
    }
  }
  EXPECT_EQ(flip_map(linear_image(grey(7)), linear_image(grey(7)), 5).size(), 1024u);
}

TEST(FlipKernels, AreNormalised) {
  const auto sum = [](const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); };
  const FlipKernels kernels = flip_kernels(ppd);
  EXPECT_EQ(radius_of(kernels.luminance), 10);
  EXPECT_EQ(radius_of(kernels.smooth), 9);
  for (const Kernel* kernel : {&kernels.luminance, &kernels.red_green, &kernels.smooth})
    EXPECT_NEAR(sum(*kernel), 1, 1e-12);
  const double narrow = sum(kernels.blue_yellow_narrow), wide = sum(kernels.blue_yellow_wide);
  EXPECT_NEAR(narrow * narrow + wide * wide, 1, 1e-12);
  for (const Kernel* kernel : {&kernels.edge, &kernels.point}) {
    EXPECT_NEAR(sum(*kernel), 0, 1e-12);
    double positive = 0;
    for (double weight : *kernel) positive += std::max(weight, 0.0);
    EXPECT_NEAR(positive, 1, 1e-12);
  }
}

TEST(ColourSpaces, HavePublishedValuesAndAnInverse) {
  EXPECT_NEAR(luminance(glm::dvec3(1)), 1, 1e-12);
  const glm::dvec3 white = ycxcz_from_linear({1, 1, 1}), black = ycxcz_from_linear({0, 0, 0});
  EXPECT_NEAR(glm::length(white - glm::dvec3(100, 0, 0)), 0, 1e-9);
  EXPECT_NEAR(glm::length(black - glm::dvec3(-16, 0, 0)), 0, 1e-9);
  const glm::dvec3 colour(0.2, 0.7, 0.05);
  EXPECT_NEAR(glm::length(linear_from_ycxcz(ycxcz_from_linear(colour)) - colour), 0, 1e-12);
  // L*a*b* of sRGB's green is (87.73, -86.18, 83.18); Hunt scales a and b by L / 100.
  EXPECT_NEAR(glm::length(hunt_lab_from_linear({0, 1, 0}) - glm::dvec3(87.73, -86.18 * 0.8773, 83.18 * 0.8773)), 0,
              0.03);
  EXPECT_NEAR(hyab({50, 3, 0}, {40, 0, 4}), 15, 1e-12);
}

}  // namespace
}  // namespace pelage
