// Sways fur: the lean of each vertex is a damped oscillator, driven by the wind and by the motion of the body. Its
// response is computed in closed form, so that any moment is computed independently and no time step is too long (Stam
// 1997, Stochastic dynamics: the response of a mode of vibration to the spectrum of the wind).
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/wind.h"
#include "server/motion/wind.h"

namespace pelage {

// The fur to which the settings of Wind apply: its length in sizes, and its lean in a wind of one size per second.
inline constexpr double sway_length = 0.03;
inline constexpr double lean_per_speed = 0.5;
/// Softer fur sways like fur of this stiffness, so that the softest fur still has a frequency.
inline constexpr double min_stiffness = 1.0 / 64;

/// o'' + 2 damping rate o' + rate^2 o = rate^2 f.
struct Oscillator {
  double rate = 1;     // radians per second, > 0
  double damping = 0;  // ratio, > 0
};

/// The complex factor of the steady response to a force e^(i w t): 1 / (1 - r^2 + 2 i damping r), r = w / rate.
struct Response {
  double real = 1, imaginary = 0;
};
Response response(const Oscillator& oscillator, double w);

/// Returns the position of the oscillator `seconds` after a force of 1 set in, from rest at 0. It converges to 1.
double step_response(const Oscillator& oscillator, double seconds);

/// The fur at a vertex: a pendulum with a spring of the given stiffness, so that its rate is proportional to the root
/// of stiffness over length. `lean` is the static offset in a wind of one size per second.
struct Spring {
  Oscillator oscillator;
  double lean = 0;
};
/// `length` in sizes, above 0; `stiffness` in its field's range.
Spring spring_of(const Wind& wind, double length, double stiffness);

/// Returns the sum of a direction of the field, of length [0, 1], and an offset of any length. A sum that is longer
/// than `rest_direction` is compressed smoothly into the unit disc. Returns `rest_direction` for no offset.
glm::dvec2 offset_direction(glm::dvec2 rest_direction, glm::dvec2 offset);

/// Returns the acceleration of the skin at a vertex, sizes per second squared, in the coordinates of the vertex's
/// normal and tangent, which rotate with the body. Called from several threads.
using BodyAcceleration = std::function<glm::dvec3(std::uint32_t vertex, double time)>;

/// The motion of a body. Its influence ends after `warm_up_seconds`, and fades out smoothly in the second half of them,
/// so that any moment is computed independently without jumps from one to the next.
inline constexpr double warm_up_seconds = 4;
struct BodyMotion {
  BodyAcceleration acceleration;
  double step = 1.0 / 60;  // seconds, [1/1000, 1]; each step has the acceleration at its middle
};

/// The pose of a rigid body: a point p of the mesh is at rotation * p + position.
struct RigidPose {
  glm::dmat3 rotation{1};
  glm::dvec3 position{0};
};
/// Returns the acceleration of a rigid body, by second differences over `step` seconds. The positions must outlive it.
BodyAcceleration acceleration_of(std::function<RigidPose(double time)> pose, std::span<const glm::vec3> positions,
                                 double step);

/// Views of the fur at rest, by vertex.
struct RestFur {
  std::span<const glm::vec3> positions, normals, tangents;
  std::span<const glm::vec2> direction;  // in (tangent, cross(normal, tangent)), of length [0, 1]
  std::span<const float> length;         // sizes
  std::span<const float> stiffness;      // empty if it is 1 everywhere
};

/// Returns whether there is any wind.
inline bool has_wind(const Wind& wind) { return wind.speed > 0; }

/// Returns the direction field at `time` (Wind::time is ignored): deterministic at any number of threads and
/// independent of earlier calls; of length [0, 1] and finite for all inputs in their ranges. Only the lean changes, not
/// the length. A vertex costs about 2.3 us of a core for the wind, and .1 us for each step of the body's warm-up.
std::vector<glm::vec2> swayed(const RestFur& fur, const Wind& wind, double time, const BodyMotion* body = nullptr);

}  // namespace pelage
