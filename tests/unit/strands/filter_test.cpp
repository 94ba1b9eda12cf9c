#include "renderer/strands/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "renderer/strands/film.h"
#include "renderer/strands/sampling.h"

namespace pelage {
namespace {

constexpr int side = 96;
const std::vector<Aov> beauty{Aov::beauty};

using PixelLook = std::function<FilmSample(int x, int y, Sampler& sampler)>;

Film film_of(const PixelLook& look, int samples, int width = side) {
  Film film(width, side, beauty, true);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int i = 0; i < samples; ++i) {
        Sampler sampler(std::uint32_t(y * width + x), std::uint32_t(i), 5);
        film.add(x, y, look(x, y, sampler));
      }
    }
  }
  return film;
}

/// Striped fur: its colour changes every 16 pixels in y, its direction halfway across, and its distance halfway down.
/// Distances within it vary a little, and light varies from strand to strand.
FilmSample striped(int x, int y, Sampler& sampler) {
  const glm::vec2 u = sampler.next2(), v = sampler.next2();
  const bool dark = y / 16 % 2 == 1, turned = x >= side / 2, near = y >= side / 2;
  FilmSample s;
  s.alpha = s.body = 1;
  s.albedo = (dark ? glm::vec3(0.1f, 0.08f, 0.06f) : glm::vec3(0.8f, 0.7f, 0.6f)) * (0.9f + 0.2f * v.x);
  s.tangent = glm::normalize((turned ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)) + 0.3f * (glm::vec3(u, v.x) - 0.5f));
  s.normal = {0, 0, 1};
  s.over_depth = (near ? 0.5f : 0.4f) + 0.002f * v.y;
  const float light = (turned ? 1.0f : 0.4f) * (near ? 1.0f : 0.5f);
  s.radiance = s.albedo * light * -std::log(1 - u.x);  // mean 1, standard deviation 1
  return s;
}

glm::vec3 striped_mean(int x, int y) {
  const bool dark = y / 16 % 2 == 1;
  const float light = (x >= side / 2 ? 1.0f : 0.4f) * (y >= side / 2 ? 1.0f : 0.5f);
  return (dark ? glm::vec3(0.1f, 0.08f, 0.06f) : glm::vec3(0.8f, 0.7f, 0.6f)) * light;
}

glm::vec3 rgb(const FloatImage& image, int x, int y) {
  const float* p = &image.rgba[4 * std::size_t(y * image.width + x)];
  return {p[0], p[1], p[2]};
}

struct Errors {
  double rmse = 0, at_edges = 0, mean = 0;
};

/// Relative error of the mean over some pixels.
double relative_error(const FloatImage& image, glm::ivec2 begin, glm::ivec2 end) {
  double found = 0, truth = 0;
  for (int y = begin.y; y < end.y; ++y) {
    for (int x = begin.x; x < end.x; ++x) found += double(rgb(image, x, y).g), truth += double(striped_mean(x, y).g);
  }
  return found / truth - 1;
}

/// Errors of the picture; `at_edges` is over pixels along an edge.
Errors errors_of(const FloatImage& image) {
  Errors errors;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec3 found(rgb(image, x, y)), truth(striped_mean(x, y));
      errors.rmse += glm::dot(found - truth, found - truth) / (3.0 * side * side);
    }
  }
  const auto along = [&](glm::ivec2 begin, glm::ivec2 end) {
    errors.at_edges = std::max(errors.at_edges, std::abs(relative_error(image, begin, end)));
  };
  for (const int x : {side / 2 - 1, side / 2}) along({x, 0}, {x + 1, side});
  for (int y = 15; y < side - 1; y += 16) {
    for (const int edge : {y, y + 1}) along({side / 2, edge}, {side, edge + 1});
  }
  errors.rmse = std::sqrt(errors.rmse);
  errors.mean = relative_error(image, {0, 0}, {side, side});
  return errors;
}

TEST(Filter, HalvesTheErrorOfFewSamplesAndKeepsEdges) {
  for (const int samples : {1, 2, 4}) {
    const Film film = film_of(striped, samples);
    const Errors before = errors_of(film.aov(Aov::beauty, false));
    const Errors after = errors_of(film.aov(Aov::beauty, true));
    EXPECT_LT(after.rmse, before.rmse / 2) << samples;
    EXPECT_LT(after.at_edges, 0.2) << samples;
    EXPECT_NEAR(after.mean, before.mean, 0.01) << samples;
  }
}

/// Strands at random heights: deep ones are dark in colour and in light, and rare.
FilmSample deep(int, int, Sampler& sampler) {
  const glm::vec2 u = sampler.next2(), v = sampler.next2();
  const float height = 1 - u.x * u.x;
  FilmSample s;
  s.alpha = s.body = 1;
  s.albedo = glm::vec3(0.8f, 0.6f, 0.4f) * (0.3f + 0.7f * height);
  s.tangent = glm::normalize(glm::vec3(v.x - 0.5f, 1, v.y - 0.5f));
  s.normal = {0, 0, 1};
  s.over_depth = 0.5f + 0.01f * height;
  s.radiance = s.albedo * height * (u.y < 0.6f ? 1.0f : 0.1f);
  return s;
}

double mean_of_image(const FloatImage& image) {
  double sum = 0;
  for (std::size_t i = 1; i < image.rgba.size(); i += 4) sum += double(image.rgba[i]);
  return sum;
}

TEST(Filter, FavoursNoLightForBeingCommon) {
  for (const int samples : {1, 2}) {
    const Film film = film_of(deep, samples);
    const double before = mean_of_image(film.aov(Aov::beauty, false));
    EXPECT_NEAR(mean_of_image(film.aov(Aov::beauty, true)) / before, 1, 0.015) << samples;
  }
}

FilmSample even(int, int, Sampler&) {
  FilmSample s;
  s.radiance = {0.3f, 0.2f, 0.1f};
  s.alpha = s.body = 1;
  s.albedo = {0.5f, 0.4f, 0};
  s.normal = s.tangent = {0, 0, 1};
  s.over_depth = 0.5f;
  return s;
}

TEST(Filter, LeavesAConstantPicture) {
  const FloatImage image = film_of(even, 1).aov(Aov::beauty, true);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      ASSERT_LT(glm::length(rgb(image, x, y) - glm::vec3(0.3f, 0.2f, 0.1f)), 1e-6f) << x << ' ' << y;
      ASSERT_EQ(image.rgba[4 * std::size_t(y * side + x) + 3], 1);
    }
  }
}

TEST(Filter, NothingIsLeftOfItAtSixtyFourSamples) {
  const Film film = film_of(striped, 64);
  EXPECT_EQ(film.aov(Aov::beauty, true).rgba, film.aov(Aov::beauty, false).rgba);
}

/// A ball over a ground with a soft shadow, in front of nothing; pixels at the silhouette are covered at random.
FilmSample ball(int x, int y, Sampler& sampler) {
  const float away = std::hypot(float(x) - 47.5f, float(y) - 47.5f) - 30;
  const glm::vec2 u = sampler.next2();
  FilmSample s;
  if (away < 2 * (u.x - 0.5f)) {
    s = even(x, y, sampler);
    s.radiance *= 2 * u.y;
  } else if (y > 48 && u.y < 0.5f) {
    s.alpha = 0.5f;
  }
  return s;
}

TEST(Filter, MixesNothingIntoWhatIsEmpty) {
  const Film film = film_of(ball, 1);
  const FloatImage before = film.aov(Aov::beauty, false), after = film.aov(Aov::beauty, true);
  glm::dvec4 sum_before(0), sum_after(0);
  double spread = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float away = std::hypot(float(x) - 47.5f, float(y) - 47.5f) - 30;
      const std::size_t i = 4 * std::size_t(y * side + x);
      const glm::vec3 colour = rgb(after, x, y);
      const float alpha = after.rgba[i + 3];
      if (away > 2.5f) {
        EXPECT_EQ(colour, glm::vec3(0)) << x << ' ' << y;
      }
      if (away > 2.5f && y < 40) {
        EXPECT_EQ(alpha, 0) << x << ' ' << y;
      }
      if (away > 8 && y > 60) spread = std::max(spread, std::abs(double(alpha) - 0.25));
      if (away < -2.5f) {
        EXPECT_EQ(alpha, 1);
      }
      for (int c = 0; c < 4; ++c) {
        sum_before[c] += double(before.rgba[i + std::size_t(c)]);
        sum_after[c] += double(after.rgba[i + std::size_t(c)]);
      }
    }
  }
  EXPECT_LT(spread, 0.12);  // error of the ground; 0.25 unfiltered
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(sum_after[c] / sum_before[c], 1, 0.01) << c;
}

TEST(Filter, SameBitsForAnyThreads) {
  const int width = 77;
  std::vector<std::uint32_t> samples(width * side);
  std::vector<float> light(4 * samples.size()), cover(samples.size(), 1), depth(2 * samples.size(), 0.5f);
  std::vector<float> three(3 * samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = 1 + i % 7;
    cover[i] = i % 11 == 0 ? 0.0f : 1.0f;
    Sampler sampler(std::uint32_t(i), 0, 1);
    for (std::size_t c = 0; c < 4; ++c) light[4 * i + c] = cover[i] * sampler.next();
    for (std::size_t c = 0; c < 3; ++c) three[3 * i + c] = cover[i] * light[4 * i + c];
  }
  const FilterSource source{width, side, samples, light, cover, depth, three, three, three};
  const FloatImage one = filter_beauty(source, 1);
  EXPECT_EQ(one.rgba, filter_beauty(source, 2).rgba);
  EXPECT_EQ(one.rgba, filter_beauty(source, 5).rgba);
}

TEST(Filter, ExtremesStayFinite) {
  const auto extreme = [](int x, int y, Sampler& sampler) {
    FilmSample s;
    const float u = sampler.next();
    s.alpha = s.body = x % 3 == 0 ? 0 : x % 3 == 1 ? 1e-30f : 1;
    s.radiance = glm::vec3(s.alpha * (u < 0.5f ? 0 : y % 2 == 0 ? 1e16f : 1e-20f));
    s.over_depth = s.alpha > 0 ? (u < 0.3f ? 1e-6f : 1e6f) : 0;
    s.albedo = glm::vec3(u < 0.2f ? 0 : 1);
    return s;
  };
  for (const int width : {1, 2, 33}) {
    for (const float value : film_of(extreme, 1, width).aov(Aov::beauty, true).rgba) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0);
    }
  }
}

}  // namespace
}  // namespace pelage
