#include "server/motion/sway.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "base/parallel.h"
#include "server/fields/field_set.h"

namespace pelage {

Response response(const Oscillator& oscillator, double w) {
  const double r = w / oscillator.rate;
  const double real = 1 - r * r, imaginary = 2 * oscillator.damping * r;
  const double square = real * real + imaginary * imaginary;
  return {real / square, -imaginary / square};
}

double step_response(const Oscillator& oscillator, double seconds) {
  const double damping = oscillator.damping, t = oscillator.rate * seconds;  // in units of 1 / rate
  if (!(t > 0)) return 0;
  constexpr double nearly = 1e-5;  // critical damping; the other formulas divide by about damping - 1
  if (std::abs(damping - 1) < nearly) return 1 - std::exp(-t) * (1 + t);
  if (damping < 1) {
    const double swing = std::sqrt(1 - damping * damping);
    return 1 - std::exp(-damping * t) * (std::cos(swing * t) + damping / swing * std::sin(swing * t));
  }
  const double spread = std::sqrt(damping * damping - 1), fast = damping + spread, slow = 1 / fast;
  return 1 - (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
}

Spring spring_of(const Wind& wind, double length, double stiffness) {
  const double strength = std::max(stiffness, min_stiffness) * sway_length / length;
  return {{glm::two_pi<double>() * wind.frequency * std::sqrt(strength), wind.damping}, lean_per_speed / strength};
}

glm::dvec2 offset_direction(glm::dvec2 rest_direction, glm::dvec2 offset) {
  const glm::dvec2 sum = rest_direction + offset;
  const double knee = glm::length(rest_direction), length = glm::length(sum), headroom = 1 - knee;
  if (length <= knee || length == 0) return sum;
  const double compressed = headroom > 0 ? knee + headroom * std::tanh((length - knee) / headroom) : 1;
  return compressed / length * sum;
}

BodyAcceleration acceleration_of(std::function<RigidPose(double time)> pose, std::span<const glm::vec3> positions,
                                 double step) {
  return [pose = std::move(pose), positions, step](std::uint32_t vertex, double time) {
    const RigidPose now = pose(time), before = pose(time - step), after = pose(time + step);
    const glm::dvec3 position(positions[vertex]);
    const auto at = [&](const RigidPose& there) { return there.rotation * position + there.position; };
    return glm::transpose(now.rotation) * ((at(before) - 2.0 * at(now) + at(after)) / (step * step));
  };
}

namespace {

/// The two vectors along the skin in which a direction is given.
struct TangentPlane {
  glm::dvec3 tangent, bitangent;
  glm::dvec2 project(glm::dvec3 vector) const { return {glm::dot(vector, tangent), glm::dot(vector, bitangent)}; }
};

/// Returns the sum of the responses to the mean wind and to each wave, in closed form.
glm::dvec2 wind_offset(const WindField& field, const Spring& spring, const TangentPlane& plane, glm::dvec3 position,
                       double time) {
  glm::dvec2 sum = plane.project(field.mean);
  for (const WindWave& wave : field.waves) {
    const double angle = wave.rate * time - (glm::dot(wave.number, position) + wave.phase);
    const Response answer = response(spring.oscillator, wave.rate);
    sum += plane.project(wave.amplitude) * (answer.real * std::cos(angle) - answer.imaginary * std::sin(angle));
  }
  return spring.lean * sum;
}

/// Returns the weight of a motion `seconds` ago: 1 in the last half of the warm-up, and before it a smooth fall to 0.
double influence_after(double seconds) {
  const double share = std::clamp(2 * seconds / warm_up_seconds - 1, 0.0, 1.0);
  return 1 - share * share * (3 - 2 * share);
}

/// Returns the response to a force per mass of -acceleration / length that is constant over each step; exact for each
/// step.
glm::dvec2 body_offset(const BodyMotion& body, const Spring& spring, double length, const TangentPlane& plane,
                       std::uint32_t vertex, double time) {
  glm::dvec2 sum(0);
  double answered = 0;
  for (int k = 0; k * body.step < warm_up_seconds; ++k) {
    const double middle = (k + 0.5) * body.step, before = answered;
    answered = step_response(spring.oscillator, (k + 1) * body.step);
    const double share = (answered - before) * influence_after(middle);
    if (share != 0) sum += share * plane.project(body.acceleration(vertex, time - middle));
  }
  return -1 / (spring.oscillator.rate * spring.oscillator.rate * length) * sum;
}

}  // namespace

std::vector<glm::vec2> swayed(const RestFur& fur, const Wind& wind, double time, const BodyMotion* body) {
  assert(!body || (body->step >= 1e-3 && body->step <= 1));
  const WindField field = make_wind(wind);
  std::vector<glm::vec2> moved(fur.direction.begin(), fur.direction.end());
  const auto move = [&](std::uint32_t v) {
    const double length = static_cast<double>(fur.length[v]);
    if (!(length > 0)) return;
    const double stiffness = fur.stiffness.empty() ? 1 : static_cast<double>(fur.stiffness[v]);
    const Spring spring = spring_of(wind, length, stiffness);
    const TangentPlane plane{fur.tangents[v], glm::cross(fur.normals[v], fur.tangents[v])};
    glm::dvec2 offset = wind_offset(field, spring, plane, fur.positions[v], time);
    if (body) offset += body_offset(*body, spring, length, plane, v, time);
    moved[v] = stored_direction(offset_direction(fur.direction[v], offset));
  };
  constexpr std::uint32_t run = 512;
  const auto count = static_cast<std::uint32_t>(moved.size());
  for_each_in_parallel((count + run - 1) / run, [&](std::uint32_t i) {
    for (std::uint32_t v = i * run; v < std::min(count, (i + 1) * run); ++v) move(v);
  });
  return moved;
}

}  // namespace pelage
