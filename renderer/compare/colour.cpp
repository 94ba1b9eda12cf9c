#include "renderer/compare/colour.h"

#include <cmath>

namespace pelage {

namespace {

/// Linear RGB to XYZ over the XYZ of white: each row sums to 1. GLM wants columns.
glm::dmat3 white_relative() {
  const glm::dmat3 rows(glm::dvec3(10135552, 8788810, 4435075) / 24577794.0,
                        glm::dvec3(2613072, 8788810, 887015) / 12288897.0,
                        glm::dvec3(1425312, 8788810, 70074185) / 73733382.0);
  glm::dmat3 scaled;
  for (int k = 0; k < 3; ++k) scaled[k] = rows[k] / (rows[k].x + rows[k].y + rows[k].z);
  return glm::transpose(scaled);
}

double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

}  // namespace

double luminance_of(const glm::dvec3& linear) { return glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722)); }

glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear) {
  static const glm::dmat3 matrix = white_relative();
  const glm::dvec3 xyz = matrix * linear;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::dvec3 linear_from_ycxcz(const glm::dvec3& ycxcz) {
  static const glm::dmat3 inverse = glm::inverse(white_relative());
  const double y = (ycxcz.x + 16) / 116;
  return glm::clamp(inverse * glm::dvec3(y + ycxcz.y / 500, y, y - ycxcz.z / 200), 0.0, 1.0);
}

glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear) {
  static const glm::dmat3 matrix = white_relative();
  const glm::dvec3 xyz = matrix * linear;
  const double x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const glm::dvec3& first, const glm::dvec3& second) {
  const glm::dvec3 d = first - second;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

}  // namespace pelage
