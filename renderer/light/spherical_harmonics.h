// Light from all around in nine numbers a channel (Ramamoorthi and Hanrahan 2001, eq 12 and 13).
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

#include "protocol/commands/look.h"

namespace pelage {

using SphericalHarmonics = std::array<glm::dvec3, 9>;

/// The nine real basis functions at a unit direction.
std::array<double, 9> harmonics_basis(glm::dvec3 direction);

/// Projects radiance by quadrature over the sphere (latitude by longitude, midpoints).
SphericalHarmonics project(const std::function<glm::dvec3(glm::dvec3 direction)>& radiance);

/// Irradiance over pi on a surface with that normal, as coefficients of the same basis: 1 everywhere for white light.
SphericalHarmonics irradiance_of(const SphericalHarmonics& radiance);

glm::dvec3 evaluate(const SphericalHarmonics& coefficients, glm::dvec3 direction);

/// Radiance of the gradient from a direction, +y up.
glm::dvec3 radiance_of(const Environment& environment, glm::dvec3 direction);

}  // namespace pelage
