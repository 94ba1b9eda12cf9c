// Closed forms against plain integration in tiny steps.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/motion/meadow.h"

namespace pelage {
namespace {

/// Integrates o'' + 2 damping rate o' + rate^2 o = rate^2 f(t) by the fourth-order Runge-Kutta method, starting at rest
/// at time `from`.
double integrated(const Oscillator& oscillator, const std::function<double(double)>& force, double from, double to) {
  const double w = oscillator.rate;
  const auto slope = [&](double o, double v, double t) {
    return w * w * (force(t) - o) - 2 * oscillator.damping * w * v;
  };
  const int steps = static_cast<int>((to - from) * 4000);
  const double h = (to - from) / steps;
  double o = 0, v = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = from + i * h;
    const double k1 = slope(o, v, t), k2 = slope(o + h / 2 * v, v + h / 2 * k1, t + h / 2);
    const double k3 = slope(o + h / 2 * v + h * h / 4 * k1, v + h / 2 * k2, t + h / 2);
    const double k4 = slope(o + h * v + h * h / 2 * k2, v + h * k3, t + h);
    o += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return o;
}

TEST(Oscillator, StepResponseIsThatOfTheEquationForEveryDamping) {
  for (const double damping : {0.02, 0.2, 0.999, 1.0, 1.000001, 1.01, 4.0}) {
    const Oscillator oscillator{9, damping};
    for (const double t : {0.05, 0.3, 1.0, 2.5})
      EXPECT_NEAR(step_response(oscillator, t),
                  integrated(
                      oscillator, [](double) { return 1; }, 0, t),
                  1e-5)
          << damping << " at " << t;
    EXPECT_EQ(step_response(oscillator, 0), 0);
    EXPECT_NEAR(step_response(oscillator, 1e4), 1, 1e-9);
  }
}

TEST(Oscillator, ResponseIsTheSteadyAnswerToAWave) {
  for (const double damping : {0.1, 1.0, 3.0}) {
    const Oscillator oscillator{12, damping};
    for (const double w : {2.0, 12.0, 50.0}) {
      const double at = 20 + 0.37 / w;
      const Response answer = response(oscillator, w);
      EXPECT_NEAR(answer.real * std::cos(w * at) - answer.imaginary * std::sin(w * at),
                  integrated(
                      oscillator, [&](double t) { return std::cos(w * t); }, 0, at),
                  1e-6)
          << damping << " at " << w;
    }
  }
}

TEST(Oscillator, LongerAndLimperFurLeansFurtherAndSwaysSlower) {
  const Wind wind;
  const Spring usual = spring_of(wind, 0.03, 1), longer = spring_of(wind, 0.12, 1), stiffer = spring_of(wind, 0.03, 4);
  EXPECT_DOUBLE_EQ(usual.lean, 0.5);
  EXPECT_DOUBLE_EQ(longer.lean, 2);
  EXPECT_DOUBLE_EQ(longer.oscillator.rate, usual.oscillator.rate / 2);
  EXPECT_DOUBLE_EQ(stiffer.lean, 0.125);
  EXPECT_DOUBLE_EQ(stiffer.oscillator.rate, usual.oscillator.rate * 2);
  EXPECT_GT(spring_of(wind, 0.03, 0).oscillator.rate, 0);
}

TEST(Sway, FurDoesWhatTheOscillatorDoesInTheWindAtItsPosition) {
  Meadow meadow = make_meadow(2);
  meadow.direction.assign(4, {0, 0});
  meadow.stiffness = {1, 4, 1, 0.5f};
  const Wind wind{.speed = 0.05, .direction = {1, 0, 1}, .gusts = 1, .turbulence = 1};  // too weak to be clamped
  const WindField field = make_wind(wind);
  const std::vector<glm::vec2> moved = swayed(meadow.fur(), wind, 3);
  for (std::uint32_t v = 0; v < 4; ++v) {
    const Spring spring = spring_of(wind, 0.03, static_cast<double>(meadow.stiffness[v]));
    const auto force = [&](int axis) {
      return [&, axis](double t) {
        return spring.lean * (axis == 0 ? 1 : -1) * field.velocity(meadow.positions[v], t)[axis];
      };
    };
    const glm::dvec2 offset(integrated(spring.oscillator, force(0), -12, 3),
                            integrated(spring.oscillator, force(2), -12, 3));  // the bitangent is -z
    EXPECT_NEAR(moved[v].x, offset_direction({0, 0}, offset).x, 1e-5);
    EXPECT_NEAR(moved[v].y, offset_direction({0, 0}, offset).y, 1e-5);
  }
}

TEST(Sway, BodyGivesTheLeanOfAPendulumInASteadyPush) {
  Meadow meadow = make_meadow(2);
  meadow.direction.assign(4, {0, 0});
  const Wind calm{.frequency = 3, .damping = 0.7};
  const BodyMotion pushed{[](std::uint32_t, double) { return glm::dvec3(2, 5, 0); }};
  const double rate = spring_of(calm, 0.03, 1).oscillator.rate;
  const glm::dvec2 expected = offset_direction({0, 0}, {-2 / (rate * rate * 0.03f), 0});
  for (const glm::vec2 lean : swayed(meadow.fur(), calm, 0, &pushed)) {
    EXPECT_NEAR(lean.x, expected.x, 1e-3);
    EXPECT_EQ(lean.y, 0);
  }
}

TEST(Sway, StepsThatDivideGiveTheSameState) {
  Meadow meadow = make_meadow(2);
  const Wind calm{};
  const auto jerks = [](std::uint32_t v, double time) {  // steps of .25 s; not 0 only in the part that has full weight
    const double k = std::floor(-time / 0.25);
    return k < 8 ? glm::dvec3(std::sin(k + v), 0, std::cos(3 * k)) : glm::dvec3(0);
  };
  const std::vector<glm::vec2> coarse = [&] {
    const BodyMotion body{jerks, 0.25};
    return swayed(meadow.fur(), calm, 0, &body);
  }();
  EXPECT_GT(largest_change(coarse, meadow.direction), 0.01);
  for (const double step : {0.125, 0.0625, 0.25 / 16}) {
    const BodyMotion body{jerks, step};
    EXPECT_LT(largest_change(swayed(meadow.fur(), calm, 0, &body), coarse), 1e-6) << step;
  }
}

TEST(Sway, RigidBodyPushesItsFurBack) {
  const std::vector<glm::vec3> positions{{0.2f, 0, 0}};
  const auto falling = acceleration_of(
      [](double t) {
        return RigidPose{glm::dmat3(1), {0, -4.9 * t * t, 0}};
      },
      positions, 1e-3);
  EXPECT_NEAR(falling(0, 0.7).y, -9.8, 1e-4);
  const auto turning = acceleration_of(
      [](double t) {
        const double c = std::cos(3 * t), s = std::sin(3 * t);
        return RigidPose{{{c, 0, -s}, {0, 1, 0}, {s, 0, c}}, {0, 0, 0}};
      },
      positions, 1e-3);
  const glm::dvec3 inwards = turning(0, 1.234);  // points to the axis in the body's own coordinates
  EXPECT_NEAR(inwards.x, -9 * 0.2, 1e-4);
  EXPECT_NEAR(glm::length(inwards - glm::dvec3(inwards.x, 0, 0)), 0, 1e-6);
}

}  // namespace
}  // namespace pelage
