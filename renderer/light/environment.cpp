#include "renderer/light/environment.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/limits.h"

namespace pelage {

namespace {

/// Projects the gradient from the ground over the horizon to the sky, +y up. It is interpolated by w = sqrt |y|, whose
/// moments over the half sphere are 2 / 3, 2 / 5 and 2 / 7 for the powers 0, 1 and 2 of |y|. It is symmetric about +y,
/// so x^2 and z^2 are (1 - y^2) / 2 on average.
SphericalHarmonics project_gradient(const Environment& environment) {
  const glm::dvec3 sky(environment.sky), horizon(environment.horizon), ground(environment.ground);
  const double around = 2 * std::numbers::pi;
  const glm::dvec3 even = sky + ground - 2.0 * horizon;
  const glm::dvec3 integral = around * (2.0 * horizon + 2.0 / 3 * even);    // integral of the radiance
  const glm::dvec3 upward = around * (2.0 / 5 * (sky - ground));            // integral of radiance times y
  const glm::dvec3 square = around * (2.0 / 3 * horizon + 2.0 / 7 * even);  // integral of radiance times y^2
  SphericalHarmonics result{};
  result[0] = harmonic_scale::constant * integral;
  result[1] = harmonic_scale::linear * upward;
  result[6] = harmonic_scale::polar * (0.5 * integral - 1.5 * square);
  result[8] = harmonic_scale::difference * (0.5 * integral - 1.5 * square);
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
  SphericalHarmonics result = radiance;  // factors of the clamped cosine over pi: 1, 2/3, 1/4
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
  // 3z^2 - 1 and x^2 - y^2 are expressed by 3y^2 - 1, which is invariant, and z^2 - x^2, which rotates with xz at twice
  // the angle.
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

namespace {

// A direction is (h X, y, h Z), where h and y are the sine and the cosine of the polar angle, and X and Z depend on the
// longitude alone. Every basis function is a sum of products of both, and so are its integrals over a pixel.

/// Integrals over the longitudes of a column.
struct ColumnMoments {
  double one = 0, x = 0, z = 0, xx = 0, zz = 0, xz = 0;
};

/// Integrals over the polar angles of a row; each includes the sine of the area element.
struct RowMoments {
  double one = 0, y = 0, h = 0, hy = 0, hh = 0, yy = 0;
};

/// Radiance times the column moments, summed along a row.
struct RowSums {
  glm::dvec3 one{0}, x{0}, z{0}, xx{0}, zz{0}, xz{0};

  void add(glm::dvec3 radiance, const ColumnMoments& column) {
    one += radiance * column.one;
    x += radiance * column.x, z += radiance * column.z;
    xx += radiance * column.xx, zz += radiance * column.zz, xz += radiance * column.xz;
  }
};

/// Returns the antiderivatives at the longitude a, with X = sin a and Z = -cos a.
ColumnMoments column_up_to(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {a, -c, -s, (a - s * c) / 2, (a + s * c) / 2, c * c / 2};
}

ColumnMoments column_moments(int column, int width) {
  const auto at = [&](int edge) { return column_up_to(2 * std::numbers::pi * (double(edge) / width - 0.5)); };
  const ColumnMoments a = at(column), b = at(column + 1);
  return {b.one - a.one, b.x - a.x, b.z - a.z, b.xx - a.xx, b.zz - a.zz, b.xz - a.xz};
}

RowMoments row_up_to(double polar) {
  const double s = std::sin(polar), c = std::cos(polar);
  return {-c, s * s / 2, (polar - s * c) / 2, s * s * s / 3, c * c * c / 3 - c, -c * c * c / 3};
}

RowMoments row_moments(int row, int height) {
  const auto at = [&](int edge) { return row_up_to(std::numbers::pi * edge / height); };
  const RowMoments a = at(row), b = at(row + 1);
  return {b.one - a.one, b.y - a.y, b.h - a.h, b.hy - a.hy, b.hh - a.hh, b.yy - a.yy};
}

void add_row(SphericalHarmonics& sum, const RowSums& s, const RowMoments& row) {
  namespace scale = harmonic_scale;
  sum[0] += scale::constant * row.one * s.one;
  sum[1] += scale::linear * row.y * s.one;
  sum[2] += scale::linear * row.h * s.z;
  sum[3] += scale::linear * row.h * s.x;
  sum[4] += scale::product * row.hy * s.x;
  sum[5] += scale::product * row.hy * s.z;
  sum[6] += scale::polar * (3 * row.hh * s.zz - row.one * s.one);
  sum[7] += scale::product * row.hh * s.xz;
  sum[8] += scale::difference * (row.hh * s.xx - row.yy * s.one);
}

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_in_range(const SphericalHarmonics& harmonics) {
  return std::all_of(harmonics.begin(), harmonics.end(), [](glm::dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= limits::harmonic;
  });
}

}  // namespace

Result<SphericalHarmonics> project_equirectangular(int width, int height, std::span<const float> rgba) {
  assert(width > 0 && height > 0 && rgba.size() == std::size_t{4} * std::size_t(width) * std::size_t(height));
  std::vector<ColumnMoments> columns;
  for (int column = 0; column < width; ++column) columns.push_back(column_moments(column, width));
  SphericalHarmonics sum{};
  const float* pixel = rgba.data();
  for (int row = 0; row < height; ++row) {
    RowSums sums;
    for (int column = 0; column < width; ++column, pixel += 4) {
      const glm::vec3 radiance(pixel[0], pixel[1], pixel[2]);
      if (!is_finite(radiance)) {
        return failure(Code::invalid, "its pixel at column " + std::to_string(column) + " of row " +
                                          std::to_string(row) + " is not finite.");
      }
      sums.add(glm::max(glm::dvec3(radiance), 0.0), columns[static_cast<std::size_t>(column)]);
    }
    add_row(sum, sums, row_moments(row, height));
  }
  if (!is_in_range(sum)) return failure(Code::invalid, "its light is too strong.");
  return sum;
}

}  // namespace pelage
