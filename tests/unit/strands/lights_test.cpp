#include "renderer/strands/lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "renderer/light/environment.h"

namespace pelage {
namespace {

constexpr double pi = std::numbers::pi;
Environment dark() {
  Environment environment;
  environment.sky = environment.horizon = environment.ground = glm::vec3(0);
  return environment;
}

StrandLights lights_of(const FurLight& light) { return {std::span(&light, 1), dark(), 1}; }

FurLight ball_at(glm::vec3 position, float radius) {
  return {.kind = LightKind::point, .position = position, .radiance = {3, 2, 1}, .radius = radius};
}

FurLight rectangle(glm::vec3 direction) {
  return {.kind = LightKind::area,
          .direction = direction,
          .position = {0.2f, 1, 0.3f},
          .radiance = {3, 2, 1},
          .soft_cone = 1,
          .extent = {1.5f, 0.5f}};
}

/// Irradiance of a matt surface with that normal: the mean of the red radiance times its cosine.
double mean_on(const StrandLights& lights, glm::vec3 position, glm::vec3 normal) {
  constexpr int side = 400;
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const LightSample s = lights.sample(0, position, (glm::vec2(i / side, i % side) + 0.5f) / float(side));
    sum += double(s.radiance.r) * std::max(0.0, double(glm::dot(s.to_light, normal)));
  }
  return sum / (side * side);
}

/// The same for a ball of radiance red / radius^2, by quadrature over its surface.
double ball_by_quadrature(const FurLight& light, glm::dvec3 position, glm::dvec3 normal) {
  constexpr int side = 800;
  const double r = double(light.radius);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const double y = 2 * (i / side + 0.5) / side - 1, around = 2 * pi * (i % side + 0.5) / side;
    const glm::dvec3 out(std::sqrt(1 - y * y) * std::cos(around), y, std::sqrt(1 - y * y) * std::sin(around));
    const glm::dvec3 apart = glm::dvec3(light.position) + r * out - position;
    const double square = glm::dot(apart, apart);
    const glm::dvec3 to_light = apart / std::sqrt(square);
    sum += std::max(0.0, -glm::dot(out, to_light)) * std::max(0.0, glm::dot(normal, to_light)) / square;
  }
  return sum * (4 * pi * r * r / (side * side)) * double(light.radiance.r) / (r * r) / pi;
}

TEST(StrandLights, BallIsThatOfItsVisibleCap) {
  const FurLight light = ball_at({0.1f, 1, -0.2f}, 0.6f);
  const StrandLights lights = lights_of(light);
  for (const glm::vec3 position : {glm::vec3(0), glm::vec3(0.3f, 0.4f, 0), glm::vec3(-2, 1, 0.5f)}) {
    for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(0.6f, 0.8f, 0), glm::vec3(1, 0, 0)}) {
      const double truth = ball_by_quadrature(light, position, normal);
      EXPECT_NEAR(mean_on(lights, position, normal), truth, 3e-3 * truth + 1e-3);
    }
  }
  const glm::vec3 towards = glm::normalize(light.position);  // facing it, the ball lights like a point in its middle
  EXPECT_NEAR(mean_on(lights, {0, 0, 0}, towards), 3 / double(glm::dot(light.position, light.position)), 1e-3);
}

TEST(StrandLights, SampledDirectionsEndOnTheBall) {
  const FurLight light = ball_at({0.1f, 1, -0.2f}, 0.6f);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 position(0.3f, 0.2f, 0.1f);
    const LightSample s = lights_of(light).sample(0, position, {float(i % 10) / 10, float(i) / 100});
    EXPECT_NEAR(glm::length(position + s.distance * s.to_light - light.position), 0.6f, 1e-5f);
    EXPECT_NEAR(glm::length(s.to_light), 1, 1e-6f);
  }
}

/// A spot's light as in light_at of lighting.glsl.
double spot_by_shader(const FurLight& light, glm::dvec3 position) {
  const glm::dvec3 apart = glm::dvec3(light.position) - position;
  const double square = glm::dot(apart, apart);
  const double inside = -glm::dot(apart, glm::dvec3(light.direction)) / std::sqrt(square);
  const double edge = double(light.cone), whole = double(light.soft_cone);
  return double(light.radiance.r) / square * std::clamp((inside - edge) / (whole - edge), 0.0, 1.0);
}

TEST(StrandLights, SmallBallsAreTheShadersPoints) {
  FurLight light = ball_at({0, 1, 0}, 0);
  light.kind = LightKind::spot;
  light.cone = 0.7f, light.soft_cone = 0.9f;
  for (const float radius : {0.0f, 1e-30f, 1e-12f, 1e-5f, 1e-3f}) {
    light.radius = radius;
    for (const glm::vec3 position :
         {glm::vec3(0), glm::vec3(0.7f, 0, 0), glm::vec3(0.5f, 0.1f, 0), glm::vec3(2, 0, 0)}) {
      const LightSample s = lights_of(light).sample(0, position, {0.3f, 0.8f});
      const double truth = spot_by_shader(light, position);
      EXPECT_NEAR(s.radiance.r, truth, 3e-6 * truth) << radius;
      EXPECT_GT(glm::dot(s.to_light, glm::normalize(light.position - position)), 1 - 2 * radius - 1e-6f);
      EXPECT_NEAR(lights_of(light).importance(0, position) / (0.2126 * 3 + 0.7152 * 2 + 0.0722) * 3, truth,
                  3e-6 * truth);
    }
  }
}

TEST(StrandLights, DirectionalIsADiscOfDirections) {
  FurLight light{.direction = {0.6f, -0.8f, 0}, .radiance = {3, 2, 1}};
  EXPECT_EQ(lights_of(light).sample(0, {}, {0.9f, 0.1f}).to_light, -light.direction);
  for (const double angle : {1e-4, 0.05, 0.5, pi / 2}) {
    light.angle = float(angle);
    const StrandLights lights = lights_of(light);
    double min = 1;
    for (int i = 0; i < 1000; ++i) {
      const LightSample s = lights.sample(0, {}, {float(i) / 1000, float(i % 7) / 7});
      EXPECT_TRUE(std::isinf(s.distance));
      min = std::min(min, double(glm::dot(s.to_light, -light.direction)));
    }
    EXPECT_NEAR(min, std::cos(angle), 2e-3 * angle + 1e-6);
    // Directions are uniform over the cone: the mean cosine is halfway between 1 and that of its edge.
    EXPECT_NEAR(mean_on(lights, {}, -light.direction), 3 * (1 + std::cos(angle)) / 2, 1e-4);
  }
}

/// The same for a rectangle with these axes, by quadrature over its surface.
double rectangle_by_quadrature(const FurLight& light, glm::dvec3 right, glm::dvec3 position, glm::dvec3 normal) {
  constexpr int side = 700;
  const glm::dvec3 facing(light.direction), up = glm::cross(facing, right);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = (i / side + 0.5) / side - 0.5, y = (i % side + 0.5) / side - 0.5;
    const glm::dvec3 off = x * double(light.extent.x) * right + y * double(light.extent.y) * up;
    const glm::dvec3 apart = glm::dvec3(light.position) + off - position;
    const double square = glm::dot(apart, apart), length = std::sqrt(square);
    sum += std::max(0.0, -glm::dot(facing, apart) / length) * std::max(0.0, glm::dot(normal, apart) / length) / square;
  }
  return sum / (side * side) * double(light.radiance.r);
}

TEST(StrandLights, RectangleShinesToOneSideByTheCosine) {
  const struct {
    glm::vec3 direction;
    glm::dvec3 right;
  } rows[] = {{{0, -1, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 0, 0}}, {{0, 0, -1}, {1, 0, 0}}, {{0.6f, -0.8f, 0}, {0, 0, 1}}};
  for (const auto& row : rows) {
    const FurLight light = rectangle(row.direction);
    const StrandLights lights = lights_of(light);
    for (const glm::vec3 position :
         {glm::vec3(0), glm::vec3(0.3f, 0.8f, 0.2f), glm::vec3(3, 2, -1), glm::vec3(0.2f, 2, 0)}) {
      const glm::vec3 normal = glm::normalize(glm::vec3(0.2f, 1, 0.4f));
      const double truth = rectangle_by_quadrature(light, row.right, position, normal);
      EXPECT_NEAR(mean_on(lights, position, normal), truth, 2e-3 * truth + 1e-7);
    }
  }
  const FurLight light = rectangle({0, -1, 0});
  const LightSample s = lights_of(light).sample(0, light.position - glm::vec3(0, 200, 0), {0.1f, 0.9f});
  EXPECT_NEAR(s.radiance.r * 40000, 3, 1e-3);  // from afar it is a point
  EXPECT_EQ(lights_of(light).sample(0, light.position + glm::vec3(0, 1, 0), {0.1f, 0.9f}).radiance, glm::vec3(0));
}

TEST(StrandLights, ExtremesStayFinite) {
  for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot, LightKind::area}) {
    for (const float radius : {0.0f, 1e-4f, 0.05f, 10.0f}) {
      const FurLight light{.kind = kind,
                           .radiance = glm::vec3(1e8f),
                           .soft_cone = 1,
                           .angle = radius,
                           .radius = radius,
                           .extent = glm::vec2(radius)};
      const StrandLights lights = lights_of(light);
      for (const glm::vec3 position : {glm::vec3(0), glm::vec3(0, -1e-20f, 0), glm::vec3(radius, 0, 0),
                                       glm::vec3(0, -radius, 0), glm::vec3(0, -1e6f, 0), glm::vec3(1e6f, 1e6f, 1e6f)}) {
        for (const glm::vec2 u : {glm::vec2(0), glm::vec2(0.5f), glm::vec2(0x1.fffffep-1f)}) {
          const LightSample s = lights.sample(0, position, u);
          EXPECT_TRUE(std::isfinite(s.radiance.r) && s.radiance.r >= 0) << int(kind) << ' ' << radius;
          EXPECT_NEAR(glm::length(s.to_light), 1, 1e-5f) << int(kind) << ' ' << radius;
          EXPECT_GE(s.distance, 0);
          EXPECT_TRUE(std::isfinite(lights.importance(0, position)));
        }
      }
    }
  }
}

/// Integrates over all directions, in even steps of height.
double over_directions(const std::function<double(glm::vec3)>& f) {
  constexpr int side = 1024;
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const double y = 2 * (i / side + 0.5) / side - 1, around = 2 * pi * (i % side + 0.5) / side;
    const double level = std::sqrt(1 - y * y);
    sum += f({level * std::cos(around), y, level * std::sin(around)});
  }
  return sum * 4 * pi / (side * side);
}

Environment lopsided() {
  SphericalHarmonics harmonics{};  // with negative values on the far side
  harmonics[0] = glm::dvec3(2, 1, 0.5);
  harmonics[1] = glm::dvec3(3, 0, -1);
  harmonics[3] = glm::dvec3(-2, 1, 1);
  harmonics[8] = glm::dvec3(0.5, 2, 0);
  Environment environment;
  environment.harmonics = harmonics;
  return environment;
}

TEST(StrandLights, EnvironmentIsSampledByItsDensity) {
  for (const Environment& environment : {Environment{}, lopsided()}) {
    const StrandLights lights({}, environment, 0.5);
    ASSERT_TRUE(lights.has_environment());
    EXPECT_NEAR(over_directions([&](glm::vec3 d) { return double(lights.environment_pdf(d)); }), 1, 1e-4);
    const auto lightness = [&](glm::vec3 d) {
      return double(glm::dot(lights.environment(d), {0.2126f, 0.7152f, 0.0722f}));
    };
    const double truth = over_directions(lightness);
    EXPECT_NEAR(double(lights.mean_environment()), truth / (4 * pi), 2e-3 * truth);
    double sum = 0, upper = 0, covered = 0;
    constexpr int side = 512;
    for (int i = 0; i < side * side; ++i) {
      const EnvironmentSample s = lights.sample_environment((glm::vec2(i / side, i % side) + 0.5f) / float(side));
      const float density = lights.environment_pdf(s.direction);
      if (std::abs(density / s.pdf - 1) > 1e-4f) ADD_FAILURE() << "at " << s.direction.x << ' ' << s.direction.y;
      EXPECT_NEAR(glm::length(s.direction), 1, 1e-5f);
      sum += lightness(s.direction) / double(s.pdf) / (side * side);
      upper += double(s.direction.y * s.direction.y) / double(s.pdf) / (side * side);
      covered += 1 / double(s.pdf) / (side * side);
    }
    EXPECT_NEAR(sum, truth, 2e-3 * truth);
    EXPECT_NEAR(upper, 4 * pi / 3, 0.03);
    EXPECT_NEAR(covered, 4 * pi, 0.05);
  }
}

TEST(StrandLights, WhiteEnvironmentIsItsAmbient) {
  const StrandLights lights({}, Environment{}, 0.5);
  EXPECT_NEAR(lights.environment({0.6f, 0.8f, 0}).g, 0.5f, 5e-4f);
  EXPECT_NEAR(lights.sample_environment({0.3f, 0.3f}).pdf, 1 / (4 * pi), 1e-4);
}

TEST(StrandLights, WithoutAnEnvironmentNoLightComesFromIt) {
  for (const StrandLights& lights : {StrandLights({}, dark(), 1), StrandLights({}, Environment{}, 0)}) {
    EXPECT_FALSE(lights.has_environment());
    const EnvironmentSample s = lights.sample_environment({0.3f, 0.9f});
    EXPECT_EQ(s.radiance, glm::vec3(0));
    EXPECT_NEAR(s.pdf, 1 / (4 * pi), 1e-5);
    EXPECT_EQ(lights.mean_environment(), 0);
  }
}

}  // namespace
}  // namespace pelage
