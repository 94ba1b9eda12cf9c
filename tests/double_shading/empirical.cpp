#include "tests/double_shading/empirical.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

template <typename Real>
Real sine_power_of(Real d, Real n) {
  const Real squared = d * d;
  if (squared >= 1) return n > 0 ? Real(0) : Real(1);
  return std::exp(n / 2 * std::log1p(-squared));
}

double sine_to(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }

glm::dvec3 unit_or_zero(const glm::dvec3& v) { return v / std::sqrt(std::max(glm::dot(v, v), 1e-12)); }

}  // namespace

double sine_power(double d, double n) { return sine_power_of(d, n); }
float sine_power(float d, float n) { return sine_power_of(d, n); }

glm::dvec3 halfway(const ScatterGeometry& geometry) { return unit_or_zero(geometry.to_light + geometry.to_camera); }

glm::dvec3 scatter_kajiya(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour) {
  const double along_light = glm::dot(geometry.tangent, geometry.to_light);
  const double along_middle = glm::dot(geometry.tangent, halfway(geometry));
  return look.diffuse * sine_power(along_light, look.diffuse_exponent) * colour +
         look.specular * sine_power(along_middle, look.specular_exponent);
}

glm::dvec3 scatter_kajiya_kay(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour) {
  const double along_light = glm::dot(geometry.tangent, geometry.to_light);
  const double along_view = glm::dot(geometry.tangent, geometry.to_camera);
  const double mirror = sine_to(along_light) * sine_to(along_view) - along_light * along_view;
  const double highlight = std::pow(std::clamp(mirror, 0.0, 1.0), look.specular_exponent);
  return look.diffuse * sine_to(along_light) * colour + look.specular * highlight;
}

double scheuermann_lobe(double along, double n) {
  const double x = std::clamp(along + 1, 0.0, 1.0);
  return x * x * (3 - 2 * x) * sine_power(along, n);
}

glm::dvec3 scatter_scheuermann(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour,
                               double strand) {
  const FibreOptics& fibre = look.fibre;
  const glm::dvec3 middle = halfway(geometry);
  const double own = fibre.shift_spread * (2 * strand - 1);
  const auto lobe = [&](double shift, double exponent) {
    const glm::dvec3 shifted = unit_or_zero(geometry.tangent + (shift + own) * geometry.normal);
    return scheuermann_lobe(glm::dot(shifted, middle), exponent);
  };
  const double wrapped = std::clamp(0.25 + 0.75 * glm::dot(geometry.normal, geometry.to_light), 0.0, 1.0);
  return (look.diffuse * wrapped + fibre.secondary_specular * lobe(fibre.secondary_shift, fibre.secondary_exponent)) *
             colour +
         look.specular * lobe(fibre.primary_shift, look.specular_exponent);
}

double backlight_fade(ShadingModel model, double facing, double reach) {
  const bool surface =
      model == ShadingModel::lengyel || model == ShadingModel::kajiya || model == ShadingModel::kajiya_kay;
  return surface && facing < 0 ? 1 - std::min(-facing, reach) / reach : 1;
}

}  // namespace pelage
