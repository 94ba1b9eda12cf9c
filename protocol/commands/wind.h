// What moves fur: the wind of a scene, and the scene's time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// A wind that blows over the whole scene, and how fur answers it. At speed 0 nothing moves. Fur .03 sizes long with a
/// stiffness of 1 sways at `frequency`; longer and limper fur sways slower and leans further (server/motion).
struct Wind {
  double speed = 0;                // sizes per second, of the mean wind, [0, 1e6]
  glm::dvec3 direction{1, 0, 0};   // where it goes, model coordinates, any length above 0
  double gusts = 0.5;              // how much the speed rises and falls, share of it, [0, 10]
  double turbulence = 0.35;        // how much the wind turns and flickers, share of the speed, [0, 10]
  double turbulence_scale = 0.25;  // of the largest eddies, sizes, [1e-3, 1e3]; gusts are four times as long and more
  std::uint32_t seed = 1;
  double frequency = 2;  // hertz, [0.01, 100]
  double damping = 0.2;  // damping ratio, [0.01, 10]; 1: fur comes back without swinging over
  double time = 0;       // the scene's time, which frames show unless they ask for another, seconds, [-1e6, 1e6]

  bool operator==(const Wind&) const = default;
};

}  // namespace pelage
