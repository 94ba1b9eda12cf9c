#include "tests/double_shading/fibre_shading.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace pelage {

namespace {

using std::numbers::pi;

/// Inclination about the axis of fibre.h, which points from tip to root.
Inclination inclination_of(const glm::dvec3& tangent, const glm::dvec3& direction) {
  const double sine = std::clamp(-glm::dot(tangent, direction), -1.0, 1.0);
  return {sine, std::sqrt(1 - sine * sine)};
}

glm::dvec3 across(const glm::dvec3& tangent, const glm::dvec3& direction) {
  return direction - tangent * glm::dot(tangent, direction);
}

/// Azimuth from the view to the light, radians. If one of them is along the strand it has none: then pi / 2, the middle
/// of the range.
double azimuth_of(const ScatterGeometry& geometry) {
  const glm::dvec3 view = across(geometry.tangent, geometry.to_camera),
                   light = across(geometry.tangent, geometry.to_light);
  const double x = glm::dot(view, light), y = -glm::dot(geometry.tangent, glm::cross(view, light));
  return x * x + y * y > 1e-20 ? std::atan2(y, x) : pi / 2;
}

bool is_fibre_model(ShadingModel model) {
  return model == ShadingModel::energy_conserving || model == ShadingModel::marschner;
}

}  // namespace

FibreShading::FibreShading(const Look& look)
    : look_(look), lobes_(energy_conserving_lobes(look.fibre)), marschner_(marschner_lobes(look.fibre)) {
  if (is_fibre_model(look.shading)) average_ = std::make_shared<const AzimuthalAverage>(look.shading, look.fibre);
}

glm::dvec3 FibreShading::absorption(const glm::dvec3& colour) const {
  const FibreOptics& fibre = look_.fibre;
  return fibre.absorption == Absorption::melanin ? absorption_from_melanin(fibre.eumelanin, fibre.pheomelanin)
                                                 : absorption_from_colour(colour, fibre.azimuthal_roughness);
}

glm::dvec3 FibreShading::empirical(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand) const {
  if (look_.shading == ShadingModel::scheuermann) return scatter_scheuermann(look_, geometry, colour, strand);
  if (look_.shading == ShadingModel::kajiya_kay) return scatter_kajiya_kay(look_, geometry, colour);
  return scatter_kajiya(look_, geometry, colour);
}

/// `azimuthal(cos_theta, azimuth, sigma_a)` returns Ap Np.
template <typename Azimuthal>
glm::dvec3 FibreShading::fibre_sum(const ScatterGeometry& geometry, const glm::dvec3& sigma_a,
                                   const Azimuthal& azimuthal) const {
  const Inclination light = inclination_of(geometry.tangent, geometry.to_light);
  const Inclination view = inclination_of(geometry.tangent, geometry.to_camera);
  const bool marschner = look_.shading == ShadingModel::marschner;
  const LobeValues m =
      marschner ? marschner_longitudinal(marschner_, light, view) : longitudinal_lobes(lobes_, light, view);
  const double cos_theta = marschner ? cos_difference(light, view) : view.cosine;
  const double gain = marschner ? pi * light.cosine : pi;
  const double azimuth = azimuth_of(geometry);
  glm::dvec3 sum(0);
  for (int channel = 0; channel < 3; ++channel) {
    const LobeValues n = azimuthal(cos_theta, azimuth, sigma_a[channel]);
    for (std::size_t p = 0; p < lobe_count; ++p) sum[channel] += gain * m[p] * n[p];
  }
  return sum;
}

glm::dvec3 FibreShading::scatter(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand) const {
  if (!is_fibre()) return empirical(geometry, colour, strand);
  return fibre_sum(geometry, absorption(colour), [&](double cos_theta, double azimuth, double sigma_a) {
    return average_at(*average_, cos_theta, azimuth, sigma_a);
  });
}

glm::dvec3 FibreShading::scatter(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand,
                                 const ScatteringTable& table) const {
  if (!is_fibre()) return empirical(geometry, colour, strand);
  return scatter_absorbed(geometry, absorption(colour), table);
}

glm::dvec3 FibreShading::scatter_absorbed(const ScatterGeometry& geometry, const glm::dvec3& absorbed,
                                          const ScatteringTable& table) const {
  assert(is_fibre());
  return fibre_sum(geometry, absorbed, [&](double cos_theta, double azimuth, double sigma_a) {
    return table_at(table, cos_theta, azimuth, absorption_coordinate(sigma_a));
  });
}

glm::dvec3 FibreShading::scatter_at_offset(const ScatterGeometry& geometry, const glm::dvec3& colour, double h) const {
  assert(look_.shading == ShadingModel::energy_conserving);
  std::optional<LobeValues> shared;  // Np, the same for all channels
  return fibre_sum(geometry, absorption(colour), [&](double cos_theta, double azimuth, double sigma_a) {
    if (!shared) shared = azimuthal_lobes(lobes_, cos_theta, h, azimuth);
    const LobeValues a = attenuation(cos_theta, h, sigma_a, lobes_.eta), &n = *shared;
    return LobeValues{a[0] * n[0], a[1] * n[1], a[2] * n[2], a[3] * n[3]};
  });
}

double offset_across(const glm::dvec3& tangent, const glm::dvec3& hit_normal, const glm::dvec3& to_camera) {
  const glm::dvec3 view = across(tangent, to_camera);
  const double length = glm::length(view);
  return length > 1e-10 ? std::clamp(-glm::dot(tangent, glm::cross(hit_normal, view)) / length, -1.0, 1.0) : 0;
}

}  // namespace pelage
