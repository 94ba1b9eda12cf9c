#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "renderer/light/environment.h"
#include "tests/unit/light/quadrature.h"

namespace pelage {
namespace {

constexpr double full_pi = std::numbers::pi;

glm::dvec3 random_direction(Random& random) {
  const double y = 2 * random.uniform() - 1, around = 2 * full_pi * random.uniform(), h = std::sqrt(1 - y * y);
  return {h * std::cos(around), y, h * std::sin(around)};
}

SphericalHarmonics only(std::size_t index) {
  SphericalHarmonics result{};
  result[index] = glm::dvec3(1);
  return result;
}

SphericalHarmonics random_harmonics(Random& random) {
  SphericalHarmonics result;
  for (glm::dvec3& v : result) v = {random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
  return result;
}

TEST(SphericalHarmonics, TheBasisIsOrthonormal) {
  for (std::size_t i = 0; i < 9; ++i) {
    const SphericalHarmonics projected = project([&](glm::dvec3 d) { return evaluate(only(i), d); });
    for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(projected[k].x, i == k ? 1 : 0, 2e-3) << i << " " << k;
  }
}

TEST(SphericalHarmonics, ConstantLightIsOneForEveryNormal) {
  const SphericalHarmonics light = irradiance_of(project([](glm::dvec3) { return glm::dvec3(1); }));
  Random random(1);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(evaluate(light, random_direction(random)).y, 1, 1e-3);
}

/// science.md 4: the clamped cosine scales the bands by full_pi, 2 full_pi / 3 and full_pi / 4; here divided by
/// full_pi.
TEST(SphericalHarmonics, ConvolutionHasTheFactorsOfTheClampedCosine) {
  const double factors[] = {1, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};
  for (std::size_t i = 0; i < 9; ++i) {
    const SphericalHarmonics convolved = irradiance_of(only(i));
    for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(convolved[k].x, i == k ? factors[i] : 0) << i << " " << k;
  }
}

/// Radiance that is a polynomial of degree 2 is represented exactly; its irradiance is compared with the integral.
TEST(SphericalHarmonics, IrradianceIsTheCosineIntegral) {
  const auto radiance = [](glm::dvec3 d) { return glm::dvec3(1 + 0.5 * d.x - 0.3 * d.y * d.z + 0.2 * d.z * d.z); };
  const SphericalHarmonics light = irradiance_of(project(radiance));
  Random random(2);
  for (int i = 0; i < 10; ++i) {
    const glm::dvec3 normal = random_direction(random);
    const auto reflected = [&](glm::dvec3 d) { return radiance(d) * std::max(0.0, glm::dot(normal, d)); };
    const double integral =
        project(reflected)[0].x * 4 * full_pi * harmonic_scale::constant;  // c0 = Y0 times the integral
    EXPECT_NEAR(evaluate(light, normal).x, integral / full_pi, 3e-3);
  }
}

/// A distant light: a normal towards it gets the most light, as much as the first three bands of a cosine hold.
TEST(SphericalHarmonics, ALobeLightsTheSideThatFacesIt) {
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, 0.5, -0.8));
  const std::array<double, 9> basis = harmonics_basis(towards);
  SphericalHarmonics radiance{};
  for (std::size_t i = 0; i < 9; ++i)
    radiance[i] = glm::dvec3(full_pi * basis[i]);  // irradiance full_pi on a surface that faces it
  const SphericalHarmonics light = irradiance_of(radiance);
  EXPECT_NEAR(evaluate(light, towards).x, 0.25 + 0.5 + 0.3125, 1e-12);
  EXPECT_NEAR(evaluate(light, -towards).x, 0.25 - 0.5 + 0.3125, 1e-12);
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 normal = random_direction(random);
    const double c = glm::dot(normal, towards);
    EXPECT_NEAR(evaluate(light, normal).x, 0.25 + 0.5 * c + 0.15625 * (3 * c * c - 1), 1e-12);
  }
}

TEST(SphericalHarmonics, TurningMovesTheLightAboutTheUpAxis) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const SphericalHarmonics light = random_harmonics(random);
    const double angle = 7 * random.uniform() - 3.5;
    const SphericalHarmonics after = turned(light, angle);
    const glm::dvec3 d = random_direction(random);
    const glm::dvec3 there(std::cos(angle) * d.x + std::sin(angle) * d.z, d.y,
                           std::cos(angle) * d.z - std::sin(angle) * d.x);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(evaluate(after, there)[k], evaluate(light, d)[k], 1e-12);
  }
}

TEST(SphericalHarmonics, AnEnvironmentIsTurnedAndScaled) {
  Random random(5);
  Environment environment;
  environment.harmonics = random_harmonics(random);
  environment.turn_degrees = 90, environment.intensity = 3;
  const glm::dvec3 from_behind = evaluate(*environment.harmonics, {0, 0, -1});
  const glm::dvec3 from_the_left = evaluate(harmonics_of(environment), {-1, 0, 0});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(from_the_left[k], 3 * from_behind[k], 1e-12);
}

/// Against brute force. sqrt |y| bends sharply at the horizon, where the strips of the quadrature limit the accuracy.
TEST(SphericalHarmonics, AGradientIsItsIntegral) {
  Random random(6);
  const auto colour = [&] { return glm::vec3(random.uniform(), random.uniform(), random.uniform()); };
  const Environment environment{
      .sky = colour(), .horizon = colour(), .ground = colour(), .harmonics = {}, .intensity = 2};
  const auto radiance = [&](glm::dvec3 d) {
    const glm::dvec3 end(d.y >= 0 ? environment.sky : environment.ground);
    return 2.0 * glm::mix(glm::dvec3(environment.horizon), end, std::sqrt(std::abs(d.y)));
  };
  const SphericalHarmonics expected = project(radiance, 256), light = harmonics_of(environment);
  for (std::size_t i = 0; i < 9; ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(light[i][k], expected[i][k], 1e-3) << i;
}

TEST(SphericalHarmonics, AGradientIsBrightWhereItsColourIs) {
  const Environment environment{
      .sky = {1, 0, 0}, .horizon = {0, 1, 0}, .ground = {0, 0, 1}, .harmonics = {}, .intensity = 2};
  const SphericalHarmonics light = harmonics_of(environment);
  const glm::dvec3 above = evaluate(light, {0, 1, 0}), beside = evaluate(light, {1, 0, 0}),
                   below = evaluate(light, {0, -1, 0});
  EXPECT_GT(above.x, beside.x + 0.3);
  EXPECT_GT(beside.x, below.x + 0.1);
  EXPECT_GT(beside.y, above.y + 0.3);
  EXPECT_GT(below.z, beside.z + 0.3);
}

}  // namespace
}  // namespace pelage
