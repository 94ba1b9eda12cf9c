// The wind of a scene, which moves its fur, and the scene's time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// A wind over the whole scene, and how fur responds to it. At speed 0 nothing moves. Fur .03 sizes long with a
/// stiffness of 1 sways at `frequency`; longer and limper fur sways slower and leans further (server/motion).
struct Wind {
  double speed = 0;                // speed of the mean wind, sizes per second, [0, 1e6]
  glm::dvec3 direction{1, 0, 0};   // direction in which it blows, model coordinates, any length above 0
  double gusts = 0.5;              // how much the speed varies, share of the speed, [0, 10]
  double turbulence = 0.35;        // strength of the turbulence, share of the speed, [0, 10]
  double turbulence_scale = 0.25;  // size of the largest eddies, sizes, [1e-3, 1e3]; gusts are 4 to 16 times as long
  std::uint32_t seed = 1;
  double frequency = 2;  // hertz, [0.01, 100]
  double damping = 0.2;  // damping ratio, [0.01, 10]; 1: critically damped, fur comes back without overshoot
  double time = 0;       // time that frames show unless they ask for another, seconds, [-1e6, 1e6]

  bool operator==(const Wind&) const = default;
};

}  // namespace pelage
