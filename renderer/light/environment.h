// Light from all around in nine numbers a channel (Ramamoorthi and Hanrahan 2001, eq 12 and 13).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "base/status.h"
#include "protocol/commands/look.h"

namespace pelage {

/// The constants of the basis: 1; y, z and x; xy, yz and xz; 3z^2 - 1; x^2 - y^2.
namespace harmonic_scale {
inline constexpr double constant = 0.28209479177387814;
inline constexpr double linear = 0.4886025119029199;
inline constexpr double product = 1.0925484305920792;
inline constexpr double polar = 0.31539156525252005;
inline constexpr double difference = 0.5462742152960396;
}  // namespace harmonic_scale

/// The nine real basis functions at a unit direction.
std::array<double, 9> harmonics_basis(glm::dvec3 direction);

/// Irradiance over pi on a surface with that normal, as coefficients of the same basis: 1 everywhere for white light.
SphericalHarmonics irradiance_of(const SphericalHarmonics& radiance);

glm::dvec3 evaluate(const SphericalHarmonics& coefficients, glm::dvec3 direction);

/// What comes from a direction then comes from that direction turned about +y, counter-clockwise seen from above.
/// Exact.
SphericalHarmonics turned(const SphericalHarmonics& coefficients, double radians);

/// Radiance of the environment, turned and times its intensity.
SphericalHarmonics harmonics_of(const Environment& environment);

// Light from all around as a picture.

/// Projects the radiance of a picture of all directions: rows from the top (+y) to the bottom, its middle looks along
/// -z, its right quarter along +x. `rgba` has 4 * width * height numbers in linear light; alpha is not looked at. Each
/// pixel is a patch of constant radiance and its integrals are exact, so that one pixel is uniform light. Numbers below
/// 0, which filters leave behind at sharp edges, count as 0. Refused (invalid) when a pixel is not finite, and when the
/// light is too strong for limits::harmonic.
Result<SphericalHarmonics> project_equirectangular(int width, int height, std::span<const float> rgba);

}  // namespace pelage
