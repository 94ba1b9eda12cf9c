// With any wind, fur, time and body motion, leans are finite, lie in the unit disc and have bounded speed.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "server/motion/sway.h"

namespace pelage {
namespace {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) * 1e-6;
}
/// Often an end of the range, else log-uniform.
double any(double low, double high) {
  const double min_positive = std::max(low, 1e-6);
  return *rc::gen::element(low, high, std::exp(between(std::log(min_positive), std::log(high))));
}
glm::dvec3 any_vector() {
  const glm::dvec3 made(between(-1, 1), between(-1, 1), between(-1, 1));
  return glm::length(made) > 1e-3 ? made : glm::dvec3(0, 0, 1e-6);
}

Wind any_wind() {
  return {.speed = any(0, 1e6),
          .direction = any_vector() * any(1e-6, 1e6),
          .gusts = any(0, 10),
          .turbulence = any(0, 10),
          .turbulence_scale = any(1e-3, 1e3),
          .seed = static_cast<std::uint32_t>(between(0, 4294967295.0)),
          .frequency = any(0.01, 100),
          .damping = any(0.01, 10)};
}

RC_GTEST_PROP(Sway, IsFiniteAndInTheDisc, ()) {
  const glm::dvec3 normal = glm::normalize(any_vector());
  const glm::dvec3 tangent =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const double angle = between(0, 6.3), inclination = any(0, 1) * (1 - 1e-7);
  const glm::vec3 positions[] = {any_vector() / 2.0}, normals[] = {normal}, tangents[] = {tangent};
  const glm::vec2 direction[] = {inclination * glm::dvec2(std::cos(angle), std::sin(angle))};
  const float length[] = {static_cast<float>(any(0, 10))}, stiffness[] = {static_cast<float>(any(0, 4))};
  const RestFur fur{positions, normals, tangents, direction, length, stiffness};
  const double push = any(0, 1e12);
  const BodyMotion body{[&](std::uint32_t, double t) { return push * glm::dvec3(std::sin(9 * t), std::cos(t), 1); },
                        any(1e-3, 1)};
  const double time = any(0, 1e6) * *rc::gen::element(-1, 1);
  const Wind wind = any_wind();
  for (const BodyMotion* motion : {static_cast<const BodyMotion*>(nullptr), &body}) {
    const std::vector<glm::vec2> moved = swayed(fur, wind, time, motion);
    RC_ASSERT(moved.size() == 1u);
    RC_ASSERT(std::isfinite(moved[0].x) && std::isfinite(moved[0].y));
    RC_ASSERT(glm::length(glm::dvec2(moved[0])) <= 1.0);
    if (!(length[0] > 0)) RC_ASSERT(moved[0] == direction[0]);
  }
}

/// The response of an oscillator to a wave is at most its peak, 1 / (2 damping sqrt(1 - damping^2)), and its step
/// response is at most 2.
RC_GTEST_PROP(Sway, EnergyIsBounded, ()) {
  const Oscillator oscillator{any(1e-3, 1e3), any(0.01, 10)};
  const Response answer = response(oscillator, any(0, 1e12));
  const double d = oscillator.damping, peak = d < std::sqrt(0.5) ? 1 / (2 * d * std::sqrt(1 - d * d)) : 1;
  RC_ASSERT(std::hypot(answer.real, answer.imaginary) <= peak * (1 + 1e-9));
  const double there = step_response(oscillator, any(0, 1e6));
  RC_ASSERT(there >= -1e-9 && there <= 2);
}

}  // namespace
}  // namespace pelage
