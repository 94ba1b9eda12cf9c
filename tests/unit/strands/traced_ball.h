// A furred ball for tests, and traced pictures of it.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "renderer/strands/tracer.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {

inline constexpr std::size_t plenty = std::size_t{1} << 30;

inline bool always() { return true; }

/// A ball of radius .25 with its fur, for a backplate that shows nothing: then its skin is matt and coloured like the
/// roots.
inline FurPatch fur_ball(float fur) {
  constexpr int rows = 24, columns = 48;
  constexpr float pi = std::numbers::pi_v<float>;
  FurPatch ball;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const float theta = pi * static_cast<float>(y) / rows, phi = 2 * pi * static_cast<float>(x) / columns;
      const glm::vec3 normal(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
      ball.positions.push_back(0.25f * normal);
      ball.normals.push_back(normal);
      ball.tangents.emplace_back(-std::sin(phi), 0, -std::cos(phi));
      ball.direction.emplace_back(0.3f, 0.2f);
      ball.length.push_back(fur);
    }
  }
  const auto at = [](int x, int y) { return static_cast<unsigned>(y * (columns + 1) + x); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (const glm::uvec3 t : {glm::uvec3(at(x, y), at(x, y + 1), at(x + 1, y + 1)),
                                 glm::uvec3(at(x, y), at(x + 1, y + 1), at(x + 1, y))}) {
        ball.add(t);
        for (int k = 0; k < 3; ++k) {
          FurCorner& corner = ball.corners.back()[static_cast<std::size_t>(k)];
          const unsigned column = t[k] % (columns + 1), row = t[k] / (columns + 1);
          corner.tile_uv = glm::vec2(column, row) * (0.25f * pi / rows);
          corner.tile_axis = ball.tangents[t[k]];
        }
      }
    }
  }
  return ball;
}

inline Coat coat_of(glm::vec3 colour, int count = 1500) {
  Coat coat;
  coat.count = count;
  coat.colour_spread = 0;
  coat.width_root = 0.002, coat.width_tip = 0.001;
  coat.ramp = {{0, colour}};
  return coat;
}

inline FurFrame frame_at(int size, Coat coat, Transport transport, int passes) {
  FurFrame frame;
  frame.coat() = std::move(coat);
  frame.camera = {
      .position = {0, 0, 2}, .right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}, .tan_half_fov = 0.2f};
  frame.width = frame.height = size;
  frame.knobs = knobs_of(Tier::reference);
  frame.knobs.trace.transport = transport;
  frame.knobs.trace.passes = passes;
  frame.knobs.trace.filter = false;
  frame.look.ambient = 1;
  return frame;
}

inline Backplate nothing() {
  FloatImage none{.width = 1, .height = 1, .rgba = std::vector<float>(4, 0.0f)};
  return {none, none, none, none, none};
}

struct Traced {
  FloatImage beauty;
  TraceReport report;
};

inline Traced traced(const FurPatch& fur, const FurFrame& frame, int threads = 2) {
  Tracer tracer(threads, plenty, false);
  const Status begun = tracer.begin(fur.model(), fur.fields(), frame, nothing(), std::array{Aov::beauty}, always);
  EXPECT_TRUE(begun.ok()) << begun.message;
  while (begun.ok() && tracer.report().end == TraceEnd::none) EXPECT_TRUE(tracer.add_pass(always).ok());
  return {tracer.aov(Aov::beauty), tracer.report()};
}

struct Mean {
  double red = 0, alpha = 0;
};

inline Mean mean_of(const FloatImage& image) {
  Mean mean;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) mean.red += image.rgba[i], mean.alpha += image.rgba[i + 3];
  return mean;
}

inline void expect_finite(const FloatImage& image) {
  for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value) && value >= 0) << value;
}

inline FurLight light_from(glm::vec3 direction, float radiance) {
  FurLight light;
  light.direction = glm::normalize(direction), light.radiance = glm::vec3(radiance), light.angle = 0.05f;
  return light;
}

}  // namespace pelage
