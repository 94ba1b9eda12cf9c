// The environment's light as spherical harmonics, nine coefficients for each channel (Ramamoorthi and Hanrahan 2001, eq
// 12 and 13).
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

/// Returns the nine real basis functions at a unit direction.
std::array<double, 9> harmonics_basis(glm::dvec3 direction);

/// Returns irradiance over pi as a function of the surface normal, in the same basis: 1 everywhere for white light.
SphericalHarmonics irradiance_of(const SphericalHarmonics& radiance);

glm::dvec3 evaluate(const SphericalHarmonics& coefficients, glm::dvec3 direction);

/// Returns the environment rotated by `radians` about +y, counter-clockwise as seen from above. Exact.
SphericalHarmonics turned(const SphericalHarmonics& coefficients, double radians);

/// Returns the radiance of the environment, rotated and scaled by its intensity.
SphericalHarmonics harmonics_of(const Environment& environment);

// Environment pictures.

/// Projects an equirectangular picture onto the basis: rows from the top (+y) to the bottom; the middle of the picture
/// looks along -z, the right quarter along +x. `rgba` has 4 * width * height numbers in linear light; alpha is ignored.
/// Each pixel is a patch of constant radiance and its integrals are exact, so one pixel is uniform light. Negative
/// numbers, which filters leave at sharp edges, count as 0. Fails with invalid if a pixel is not finite or the light
/// exceeds limits::harmonic.
Result<SphericalHarmonics> project_equirectangular(int width, int height, std::span<const float> rgba);

}  // namespace pelage
