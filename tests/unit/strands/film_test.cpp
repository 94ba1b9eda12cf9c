#include "renderer/strands/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/colour_space.h"
#include "renderer/strands/sampling.h"

namespace pelage {
namespace {

const std::vector<Aov> film_aovs{Aov::beauty,  Aov::alpha,  Aov::depth,  Aov::position, Aov::normal,
                                 Aov::tangent, Aov::albedo, Aov::direct, Aov::shadow,   Aov::sample_count};

FilmSample hit(float brightness) {
  FilmSample s;
  s.radiance = glm::vec3(brightness);
  s.alpha = s.body = 1;
  s.over_depth = 0.5f;
  s.position = {1, 2, 3};
  s.normal = {0, 1, 0};
  s.tangent = {1, 0, 0};
  s.albedo = glm::vec3(0.8f, 0.4f, 0.2f);
  s.direct = glm::vec3(brightness / 2);
  s.light = {0.25f, 1};
  return s;
}

glm::vec4 pixel_of(const Film& film, Aov aov, int x = 0, int y = 0) {
  const FloatImage image = film.aov(aov, false);
  const std::size_t i = 4 * std::size_t(y * image.width + x);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

TEST(Film, AveragesTheAovsOfAPartlyCoveredPixel) {
  Film film(1, 1, film_aovs, false);
  film.add(0, 0, hit(2));
  FilmSample ground;
  ground.alpha = 0.5f;
  film.add(0, 0, ground);
  film.add(0, 0, hit(4));
  film.add(0, 0, {});
  EXPECT_EQ(film.samples(0, 0), 4);
  EXPECT_EQ(film.mean_samples(), 4);
  EXPECT_EQ(pixel_of(film, Aov::beauty), glm::vec4(1.5f, 1.5f, 1.5f, 0.625f));
  EXPECT_EQ(pixel_of(film, Aov::alpha).a, 0.625f);
  EXPECT_FLOAT_EQ(pixel_of(film, Aov::depth).r, 0.5f);
  const struct {
    Aov aov;
    glm::vec3 value;
  } rows[] = {{Aov::position, {1, 2, 3}},        {Aov::normal, {0, 1, 0}},        {Aov::tangent, {1, 0, 0}},
              {Aov::albedo, {0.4f, 0.2f, 0.1f}}, {Aov::direct, glm::vec3(0.75f)}, {Aov::shadow, glm::vec3(0.25f)},
              {Aov::sample_count, glm::vec3(4)}};
  for (const auto& row : rows) {
    const glm::vec4 found = pixel_of(film, row.aov);
    EXPECT_LT(glm::length(glm::vec3(found) - row.value), 1e-6f) << int(row.aov);
    EXPECT_EQ(found.a, 0.5f) << int(row.aov);
  }
}

TEST(Film, PixelsWithoutHitsAreEmpty) {
  Film film(2, 1, film_aovs, true);
  film.add(0, 0, {});
  for (const Aov aov : film_aovs) {
    for (const int x : {0, 1}) {
      const glm::vec4 found = pixel_of(film, aov, x);
      float expected = aov == Aov::shadow ? 1.0f : 0.0f;
      if (aov == Aov::sample_count) expected = float(1 - x);
      EXPECT_EQ(found, glm::vec4(glm::vec3(expected), 0)) << int(aov);
    }
  }
  for (int i = 0; i < 3; ++i) film.add(0, 0, i == 0 ? hit(1) : FilmSample{});
  EXPECT_EQ(pixel_of(film, Aov::depth).r, 0);  // fur covers less than half of the pixel
}

TEST(Film, TakesTheMemoryItSays) {
  const std::vector<Aov> beauty{Aov::beauty}, alpha{Aov::alpha}, depth{Aov::depth};
  EXPECT_EQ(Film::bytes(10, 7, beauty, false), 70u * 4 * (1 + 4 + 1));
  EXPECT_EQ(Film::bytes(10, 7, beauty, true), 70u * 4 * (1 + 4 + 1 + 1 + 2 + 9));
  EXPECT_EQ(Film::bytes(10, 7, alpha, false), 70u * 4 * (1 + 4));
  EXPECT_EQ(Film::bytes(10, 7, depth, true), 70u * 4 * (1 + 1 + 2));
  EXPECT_EQ(Film::bytes(10, 7, film_aovs, true), 70u * 4 * (1 + 4 + 1 + 1 + 2 + 15 + 2));
  EXPECT_EQ(Film::bytes(8192, 8192, film_aovs, true), std::size_t{8192} * 8192 * 104);
}

TEST(Film, MeansOfManySamplesDoNotDrift) {
  Film film(1, 1, film_aovs, false);
  glm::dvec2 sum(0);
  constexpr std::uint32_t count = 65536;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float u = Sampler(0, i * 7919u, i).next(), bright = u < 0.01f ? 300.0f : 0.1f + u;
    film.add(0, 0, hit(bright));
    sum += glm::dvec2(double(bright), double(bright / 2));
  }
  EXPECT_NEAR(double(pixel_of(film, Aov::beauty).g) / (sum.x / count), 1, 2e-5);
  EXPECT_NEAR(double(pixel_of(film, Aov::direct).g) / (sum.y / count), 1, 2e-5);
  EXPECT_NEAR(pixel_of(film, Aov::albedo).r, 0.8f, 1e-6f);
  EXPECT_NEAR(pixel_of(film, Aov::position).z, 3, 1e-5f);
}

double shown(double linear) {
  const double x = 0.72 * linear, film = std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
  return srgb_from_linear(film);
}

/// Samples with mean `mean` and a long tail; the mean of -log(u) is 1.
float sample_about(float mean, std::uint32_t pixel, std::uint32_t i) {
  const auto scrambled = [](std::uint32_t x) { return Sampler(x * 2654435761u, x ^ 0x55555u, 3).next(); };
  const float u = scrambled(pixel * 4096 + i);
  return mean * (0.6f - 0.4f * std::log(1 - u));
}

TEST(Film, NoiseIsTheMeanErrorOfWhatIsShown) {
  const std::vector<Aov> beauty{Aov::beauty};
  for (const double exposure : {0.0, -2.0, 1.5}) {
    for (const std::uint32_t samples : {16u, 64u}) {
      Film film(32, 16, beauty, false);
      double error[2] = {};
      for (int pixel = 0; pixel < 512; ++pixel) {
        const int x = pixel % 32, y = pixel / 32;
        const float mean = x < 16 ? 0.05f : 0.4f + 0.01f * float(y);
        for (std::uint32_t i = 0; i < samples; ++i) film.add(x, y, hit(sample_about(mean, std::uint32_t(pixel), i)));
        const double factor = std::exp2(exposure), found = double(pixel_of(film, Aov::beauty, x, y).g);
        error[x / 16] += std::abs(shown(factor * found) - shown(factor * double(mean))) / 256;
      }
      for (const int tile : {0, 1}) EXPECT_NEAR(film.noise(tile, exposure) / error[tile], 1, 0.15) << samples;
      EXPECT_NEAR(film.noise(exposure), (film.noise(0, exposure) + film.noise(1, exposure)) / 2, 1e-12);
    }
  }
}

TEST(Film, NoiseIsInfiniteUntilItIsKnown) {
  Film film(20, 20, film_aovs, false);
  ASSERT_EQ(film.tiles().size(), 4u);
  EXPECT_TRUE(std::isinf(film.noise(0, 0)));
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(std::isinf(film.noise(0)));
    for (int pixel = 0; pixel < 400; ++pixel)
      film.add(pixel % 20, pixel / 20, pixel < 16 ? hit(float(i)) : FilmSample{});
  }
  EXPECT_GT(film.noise(0, 0), 0);
  EXPECT_EQ(film.noise(3, 0), 0);              // nothing is seen there
  EXPECT_EQ(film.noise(0), film.noise(0, 0));  // so it does not count in the mean
  const std::vector<Aov> alpha{Aov::alpha};
  EXPECT_TRUE(std::isinf(Film(4, 4, alpha, false).noise(0)));
}

}  // namespace
}  // namespace pelage
