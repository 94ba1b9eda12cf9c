// The wind as a sum of travelling waves, after Shinya and Fournier 1992 (Stochastic motion) and the random Fourier
// modes of Kraichnan 1970.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/wind.h"

namespace pelage {

/// A wave of velocity: amplitude * cos(rate * t - (number . x + phase)). The response of fur has a closed form
/// (sway.h).
struct WindWave {
  glm::dvec3 amplitude{0};  // sizes per second
  glm::dvec3 number{0};     // wave vector, radians per size
  double rate = 0;          // radians per second; of either sign
  double phase = 0;         // radians, [0, 2 pi)
};

/// A mean wind and waves. Gusts are long waves that strengthen and weaken the wind and travel with it, so that they
/// visibly run over a meadow. Turbulence has eddies up to `turbulence_scale`, whose energy falls with the
/// wave number k as k^(-5/3) (Kolmogorov 1941); its velocity is orthogonal to its wave vectors, so that it is free of
/// divergence. Both change as they travel.
struct WindField {
  glm::dvec3 mean{0};  // sizes per second
  std::vector<WindWave> waves;

  /// Returns the velocity, sizes per second, at an internal position and a time in seconds. Pure; finite for every wind
  /// of the contract.
  glm::dvec3 velocity(glm::dvec3 position, double time) const;
};

/// Makes the wind of the settings, of which `time` is ignored. Deterministic. No waves at speed 0.
WindField make_wind(const Wind& wind);

}  // namespace pelage
