// How fur sways: the lean of each vertex as a damped oscillator that the wind and the motion of the body drive. It
// answers exactly, so any moment is computed by itself and no step of time is too long (Stam 1997, Stochastic dynamics:
// the response of a mode of vibration to the spectrum of the wind).
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/wind.h"
#include "server/motion/wind.h"

namespace pelage {

// The fur whose settings are those of the contract: length in sizes, and the lean in a wind of one size per second.
inline constexpr double sway_length = 0.03;
inline constexpr double lean_per_speed = 0.5;
/// Limper fur sways as this: the limpest still has a frequency.
inline constexpr double min_stiffness = 1.0 / 64;

/// o'' + 2 damping rate o' + rate^2 o = rate^2 f.
struct Oscillator {
  double rate = 1;     // radians per second, > 0
  double damping = 0;  // ratio, > 0
};

/// For a force of the complex e^(i w t) the factor of its steady answer: 1 / (1 - r^2 + 2 i damping r), r = w / rate.
struct Response {
  double real = 1, imaginary = 0;
};
Response response(const Oscillator& oscillator, double w);

/// Where the oscillator is `seconds` after it was at rest at 0 and a force of 1 set in. 1 in the end.
double step_response(const Oscillator& oscillator, double seconds);

/// The fur at a vertex: a pendulum whose spring is as strong as `stiffness` says, so that its rate goes with the root
/// of stiffness over length. `lean` is the still offset in a wind of one size per second.
struct Spring {
  Oscillator oscillator;
  double lean = 0;
};
/// `length` in sizes, above 0; `stiffness` in its field's range.
Spring spring_of(const Wind& wind, double length, double stiffness);

/// A direction of the field, of length [0, 1], and an offset of any length: their sum, and beyond where the fur leans
/// at rest brought smoothly into the unit disc. `still` itself for no offset.
glm::dvec2 bent(glm::dvec2 still, glm::dvec2 offset);

/// The acceleration of the skin at a vertex, sizes per second squared, in the coordinates that the vertex's normal and
/// tangent are in: those of the body, where it turns. Called from several threads.
using BodyAcceleration = std::function<glm::dvec3(std::uint32_t vertex, double time)>;

/// How a body moves. What it did before `warm_up_seconds` ago does not count, and counts less and less from half of
/// that on: so a moment is computed by itself, and nothing jumps from one to the next.
inline constexpr double warm_up_seconds = 4;
struct BodyMotion {
  BodyAcceleration acceleration;
  double step = 1.0 / 60;  // seconds, [1/1000, 1], over which the acceleration in their middle stands
};

/// Where and how a rigid body stands: what is at p in the mesh is at turn * p + position, turn a rotation.
struct RigidPose {
  glm::dmat3 turn{1};
  glm::dvec3 position{0};
};
/// By second differences over `step` seconds. The positions outlive it.
BodyAcceleration acceleration_of(std::function<RigidPose(double time)> pose, std::span<const glm::vec3> positions,
                                 double step);

/// Fur at rest, by vertex. Views.
struct StillFur {
  std::span<const glm::vec3> positions, normals, tangents;
  std::span<const glm::vec2> direction;  // in (tangent, cross(normal, tangent)), of length [0, 1]
  std::span<const float> length;         // sizes
  std::span<const float> stiffness;      // empty: 1 everywhere
};

/// Returns whether anything moves at all.
inline bool blows(const Wind& wind) { return wind.speed > 0; }

/// The direction field at a moment (Wind::time does not count): the same bits at any number of threads and whatever was
/// computed before; of length [0, 1] and finite for all inputs in their ranges. Lengths stay: only the lean changes. A
/// vertex costs about 2.3 us of a core for the wind, and .1 us for each step of the body's warm-up.
std::vector<glm::vec2> swayed(const StillFur& fur, const Wind& wind, double time, const BodyMotion* body = nullptr);

}  // namespace pelage
