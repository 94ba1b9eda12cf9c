#include "renderer/shading/eye_optics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/shading/fresnel.h"
#include "renderer/shading/quadrature.h"

namespace pelage {

namespace {

using std::numbers::pi;

/// Light on the cap and light that enters it, for irradiance and radius 1.
struct CapLight {
  double arrived = 0;
  double entered = 0;
};

CapLight cap_light(double light_angle, double half_angle, double eta) {
  constexpr int rings = 64, turns = 256;
  CapLight light;
  for (const QuadratureNode& ring : gauss_legendre(rings, 0, half_angle)) {
    for (int i = 0; i < turns; ++i) {
      const double turn = 2 * pi * (i + 0.5) / turns;
      const double facing =
          std::cos(ring.x) * std::cos(light_angle) + std::sin(ring.x) * std::sin(light_angle) * std::cos(turn);
      if (facing <= 0) continue;
      const double arrived = ring.weight * std::sin(ring.x) * (2 * pi / turns) * facing;
      light.arrived += arrived;
      light.entered += arrived * (1 - fresnel_dielectric(std::min(facing, 1.0), eta));
    }
  }
  return light;
}

}  // namespace

std::optional<glm::dvec3> refract_ray(const glm::dvec3& incident, const glm::dvec3& normal, double index_ratio) {
  assert(index_ratio > 0);
  const double facing = -glm::dot(incident, normal);
  const double cos2 = 1 - index_ratio * index_ratio * (1 - facing * facing);
  if (cos2 < 0) return std::nullopt;
  return glm::normalize(index_ratio * incident + (index_ratio * facing - std::sqrt(cos2)) * normal);
}

double iris_shift(double depth, double incidence, double eta) {
  assert(depth >= 0 && eta >= 1);
  const double sine = std::sin(incidence);
  return depth > 0 ? depth * sine / std::sqrt(eta * eta - sine * sine) : 0;
}

double pupil_diameter_mm(double luminance, double field_degrees2) {
  assert(luminance >= 0 && field_degrees2 > 0);
  const double response = std::pow(luminance * field_degrees2 / 846, 0.41);
  return 7.75 - 5.75 / (1 + 2 / response);
}

double cornea_transmittance(double light_angle, double half_angle, double eta) {
  const CapLight light = cap_light(light_angle, half_angle, eta);
  return light.arrived > 0 ? light.entered / light.arrived : 0;
}

double cornea_cross_section(double light_angle, double half_angle) {
  return cap_light(light_angle, half_angle, 1).arrived;
}

double caustic_scale(double flux, std::span<const double> weights, std::span<const double> areas) {
  assert(weights.size() == areas.size());
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * areas[i];
  return sum > 0 ? flux / sum : 0;
}

}  // namespace pelage
