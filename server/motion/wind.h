// The wind as a sum of waves that travel, after Shinya and Fournier 1992 (Stochastic motion) and the random Fourier
// modes of Kraichnan 1970.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/wind.h"

namespace pelage {

/// amplitude * cos(rate * t - (number . x + phase)). What fur answers to it has a closed form (sway.h).
struct WindWave {
  glm::dvec3 amplitude{0};  // sizes per second
  glm::dvec3 number{0};     // radians per size
  double rate = 0;          // radians per second; of either sign
  double phase = 0;         // radians, [0, 2 pi)
};

/// A mean wind and waves about it. Gusts are long, strengthen and weaken it, and travel with it, so that they are seen
/// to run over a meadow. Turbulence is of eddies up to `turbulence_scale` whose energy falls with size as by Kolmogorov
/// 1941 (k^(-5/3)); it blows across its own waves, which keeps it free of sources. Both age as they travel.
struct WindField {
  glm::dvec3 mean{0};  // sizes per second
  std::vector<WindWave> waves;

  /// Sizes per second at an internal position at a time in seconds. Pure; finite for every wind of the contract.
  glm::dvec3 velocity(glm::dvec3 position, double time) const;
};

/// The same wind for the same settings; `time` of them does not count. No waves at speed 0.
WindField make_wind(const Wind& wind);

}  // namespace pelage
