// Integrals over the sphere by brute force, as a reference for closed forms.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "renderer/light/environment.h"

namespace pelage {

/// Projects radiance, a function of a unit direction, to coefficients (latitude by longitude, midpoint rule).
template <class Radiance>
SphericalHarmonics project(const Radiance& radiance, int latitudes = 64) {
  SphericalHarmonics sum{};
  const double step = std::numbers::pi / latitudes;
  for (int row = 0; row < latitudes; ++row) {
    const double polar = (row + 0.5) * step;
    const double area = step * (std::cos(row * step) - std::cos((row + 1) * step));  // exact area of the strip
    for (int column = 0; column < 2 * latitudes; ++column) {
      const double around = (column + 0.5) * step;
      const glm::dvec3 d(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around));
      const std::array<double, 9> basis = harmonics_basis(d);
      for (std::size_t i = 0; i < 9; ++i) sum[i] += radiance(d) * (basis[i] * area);
    }
  }
  return sum;
}

}  // namespace pelage
