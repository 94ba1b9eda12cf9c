#include "renderer/light/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace pelage {

namespace {

/// The gradient from the ground over the horizon to the sky, +y up: mixed by w = sqrt |y|, whose moments on the half sphere are
/// 2 / 3, 2 / 5 and 2 / 7 for the powers 0, 1 and 2 of |y|. The same all around +y, so x^2 and z^2 are (1 - y^2) / 2 on average.
SphericalHarmonics project_gradient(const Environment& environment) {
  const glm::dvec3 sky(environment.sky), horizon(environment.horizon), ground(environment.ground);
  const double around = 2 * std::numbers::pi;
  const glm::dvec3 even = sky + ground - 2.0 * horizon;
  const glm::dvec3 whole = around * (2.0 * horizon + 2.0 / 3 * even);       // integral of the radiance
  const glm::dvec3 upward = around * (2.0 / 5 * (sky - ground));            // of it times y
  const glm::dvec3 square = around * (2.0 / 3 * horizon + 2.0 / 7 * even);  // of it times y^2
  SphericalHarmonics result{};
  result[0] = harmonic_scale::constant * whole;
  result[1] = harmonic_scale::linear * upward;
  result[6] = harmonic_scale::polar * (0.5 * whole - 1.5 * square);
  result[8] = harmonic_scale::difference * (0.5 * whole - 1.5 * square);
  return result;
}

}  // namespace

std::array<double, 9> harmonics_basis(glm::dvec3 d) {
  namespace scale = harmonic_scale;
  return {scale::constant,
          scale::linear * d.y,
          scale::linear * d.z,
          scale::linear * d.x,
          scale::product * d.x * d.y,
          scale::product * d.y * d.z,
          scale::polar * (3 * d.z * d.z - 1),
          scale::product * d.x * d.z,
          scale::difference * (d.x * d.x - d.y * d.y)};
}

SphericalHarmonics irradiance_of(const SphericalHarmonics& radiance) {
  SphericalHarmonics result = radiance;  // the clamped cosine's factors over pi: 1, 2/3, 1/4
  for (std::size_t i = 1; i < 4; ++i) result[i] *= 2.0 / 3.0;
  for (std::size_t i = 4; i < 9; ++i) result[i] *= 0.25;
  return result;
}

glm::dvec3 evaluate(const SphericalHarmonics& coefficients, glm::dvec3 direction) {
  const std::array<double, 9> basis = harmonics_basis(direction);
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < 9; ++i) sum += coefficients[i] * basis[i];
  return sum;
}

SphericalHarmonics turned(const SphericalHarmonics& from, double radians) {
  const double c = std::cos(radians), s = std::sin(radians), c2 = std::cos(2 * radians), s2 = std::sin(2 * radians);
  const double half_root = std::numbers::sqrt3 / 2;
  SphericalHarmonics to = from;
  to[2] = c * from[2] - s * from[3];
  to[3] = c * from[3] + s * from[2];
  to[4] = c * from[4] + s * from[5];
  to[5] = c * from[5] - s * from[4];
  // 3z^2 - 1 and x^2 - y^2 in terms of 3y^2 - 1, which stays, and z^2 - x^2, which turns with xz at twice the angle.
  const glm::dvec3 stays = -0.5 * from[6] - half_root * from[8];
  const glm::dvec3 turns = half_root * from[6] - 0.5 * from[8];
  const glm::dvec3 after = c2 * turns - s2 * from[7];
  to[7] = c2 * from[7] + s2 * turns;
  to[6] = half_root * after - 0.5 * stays;
  to[8] = -half_root * stays - 0.5 * after;
  return to;
}

SphericalHarmonics harmonics_of(const Environment& environment) {
  SphericalHarmonics result = environment.harmonics
                                  ? turned(*environment.harmonics, glm::radians(environment.turn_degrees))
                                  : project_gradient(environment);
  for (glm::dvec3& coefficient : result) coefficient *= environment.intensity;
  return result;
}

}  // namespace pelage
