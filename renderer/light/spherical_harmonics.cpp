#include "renderer/light/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace pelage {

namespace {

constexpr int latitudes = 64;

}  // namespace

std::array<double, 9> harmonics_basis(glm::dvec3 d) {
  return {0.28209479177387814,
          0.4886025119029199 * d.y,
          0.4886025119029199 * d.z,
          0.4886025119029199 * d.x,
          1.0925484305920792 * d.x * d.y,
          1.0925484305920792 * d.y * d.z,
          0.31539156525252005 * (3 * d.z * d.z - 1),
          1.0925484305920792 * d.x * d.z,
          0.5462742152960396 * (d.x * d.x - d.y * d.y)};
}

SphericalHarmonics project(const std::function<glm::dvec3(glm::dvec3 direction)>& radiance) {
  SphericalHarmonics sum{};
  const double step = std::numbers::pi / latitudes;
  for (int row = 0; row < latitudes; ++row) {
    const double polar = (row + 0.5) * step;
    const double area = step * (std::cos(row * step) - std::cos((row + 1) * step));  // exact for the strip
    for (int column = 0; column < 2 * latitudes; ++column) {
      const double around = (column + 0.5) * step;
      const glm::dvec3 d(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around));
      const std::array<double, 9> basis = harmonics_basis(d);
      for (std::size_t i = 0; i < 9; ++i) sum[i] += radiance(d) * (basis[i] * area);
    }
  }
  return sum;
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

glm::dvec3 radiance_of(const Environment& environment, glm::dvec3 direction) {
  const double up = direction.y;
  const glm::dvec3 end(up >= 0 ? environment.sky : environment.ground);
  return environment.intensity * glm::mix(glm::dvec3(environment.horizon), end, std::sqrt(std::abs(up)));
}

}  // namespace pelage
