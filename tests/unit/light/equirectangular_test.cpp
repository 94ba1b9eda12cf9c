#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "renderer/light/environment.h"
#include "tests/unit/light/quadrature.h"

namespace pelage {
namespace {

constexpr double pi = std::numbers::pi;

struct Picture {
  int width, height;
  std::vector<float> rgba;

  Result<SphericalHarmonics> light() const { return project_equirectangular(width, height, rgba); }
};

Picture uniform(int width, int height, glm::vec3 colour) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.rgba.insert(picture.rgba.end(), {colour.x, colour.y, colour.z, 1});
  return picture;
}

/// Samples the function at the centres of the pixels.
Picture sampled(int width, int height, const std::function<double(glm::dvec3)>& radiance) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double around = 2 * pi * ((x + 0.5) / width - 0.5), polar = pi * (y + 0.5) / height;
      const glm::dvec3 d(std::sin(polar) * std::sin(around), std::cos(polar), -std::sin(polar) * std::cos(around));
      const auto value = static_cast<float>(radiance(d));
      picture.rgba.insert(picture.rgba.end(), {value, 2 * value, 0, 1});
    }
  }
  return picture;
}

TEST(Equirectangular, UniformLightIsUniformAtAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {7, 3}, {64, 32}, {5, 40}}) {
    const SphericalHarmonics light = uniform(width, height, {1, 2, 3}).light().value();
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(light[0][k], (k + 1) / harmonic_scale::constant, 1e-12);
    for (std::size_t i = 1; i < 9; ++i) EXPECT_LT(glm::length(light[i]), 1e-12) << width << " " << i;
  }
}

/// Checks every coefficient against quadrature over directions, which is the coarser one. Covers the sign of each axis.
TEST(Equirectangular, AgreesWithTheProjectionOfTheSameFunction) {
  const auto radiance = [](glm::dvec3 d) {
    return 3 + d.x - 0.5 * d.y + 0.7 * d.z + 0.4 * d.x * d.y - 0.6 * d.y * d.z + d.x * d.z + d.z * d.z -
           0.3 * d.x * d.x;
  };
  const SphericalHarmonics light = sampled(400, 200, radiance).light().value();
  const SphericalHarmonics expected = project([&](glm::dvec3 d) { return radiance(d) * glm::dvec3(1, 2, 0); });
  for (std::size_t i = 0; i < 9; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(light[i][k], expected[i][k], 1e-2) << i;
  }
}

/// The light of one bright pixel comes from the direction that the contract states.
TEST(Equirectangular, TheMiddleLooksAlongMinusZAndTheRightQuarterAlongX) {
  const auto brightest = [](int x, int y) {
    Picture picture = uniform(8, 5, glm::vec3(0));
    picture.rgba[static_cast<std::size_t>(4 * (8 * y + x))] = 1;
    const SphericalHarmonics light = picture.light().value();
    return glm::normalize(glm::dvec3(light[3].x, light[1].x, light[2].x));
  };
  const auto at = [](double column) {
    const double around = 2 * pi * ((column + 0.5) / 8 - 0.5);
    return glm::dvec3(std::sin(around), 0, -std::cos(around));
  };
  for (int x = 0; x < 8; ++x) EXPECT_LT(glm::distance(brightest(x, 2), at(x)), 1e-12) << x;
  EXPECT_GT(brightest(6, 2).x, 0.9);
  EXPECT_LT(brightest(1, 2).x, -0.9);
  EXPECT_LT(brightest(4, 2).z, -0.9);
  EXPECT_GT(brightest(3, 0).y, 0.9);
  EXPECT_LT(brightest(3, 4).y, -0.9);
}

TEST(Equirectangular, RowsCountByTheirArea) {
  Picture picture = uniform(4, 3, glm::vec3(0));
  for (std::size_t i = 0; i < 16; ++i)
    picture.rgba[i] = 1;  // the upper third of the polar angle: (1 - cos 60) / 2 of the sphere
  EXPECT_NEAR(picture.light().value()[0].x * harmonic_scale::constant, 0.25, 1e-12);
}

TEST(Equirectangular, NumbersBelowNothingCountAsNothing) {
  Picture picture = uniform(4, 2, glm::vec3(1));
  Picture without = picture;
  picture.rgba[5] = -100;
  without.rgba[5] = 0;
  EXPECT_EQ(*picture.light(), *without.light());
}

TEST(Equirectangular, WhatIsNotFiniteOrTooStrongIsRefused) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    Picture picture = uniform(4, 2, glm::vec3(1));
    picture.rgba[4 * 6 + 1] = bad;
    const Result<SphericalHarmonics> light = picture.light();
    ASSERT_FALSE(light.ok());
    EXPECT_EQ(light.status().code, Code::invalid);
    EXPECT_NE(light.status().message.find("column 2 of row 1"), std::string::npos) << light.status().message;
  }
  EXPECT_TRUE(uniform(2, 1, glm::vec3(2e5f)).light().ok());
  EXPECT_FALSE(uniform(2, 1, glm::vec3(std::numeric_limits<float>::max())).light().ok());
}

TEST(Equirectangular, AlphaIsNotLookedAt) {
  Picture picture = uniform(2, 1, glm::vec3(1));
  picture.rgba[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(picture.light().ok());
}

}  // namespace
}  // namespace pelage
