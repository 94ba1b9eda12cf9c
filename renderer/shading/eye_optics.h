// Optics of the eye (science.md 5; character rendering): what the cornea does to a ray, and how the pupil answers
// light.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace pelage {

constexpr double cornea_index = 1.376;
constexpr double aqueous_index = 1.336;
constexpr double cornea_radius_mm = 7.8;
constexpr double lens_depth_mm = 3.6;  // behind the front of the cornea

/// The direction behind a surface. `incident` goes towards it, `normal` against the ray, both unit; `index_ratio` > 0
/// is the index before over the index behind: 1/n into the eye. Empty at total reflection, where GLSL's refract answers
/// a zero vector that looks like a direction.
std::optional<glm::dvec3> refract_ray(const glm::dvec3& incident, const glm::dvec3& normal, double index_ratio);

/// How far across an iris at `depth` >= 0 behind a flat surface the ray lands from where it entered: depth
/// tan(refracted). `incidence` in [0, pi/2] radians, `eta` >= 1; the unit is that of `depth`. Finite but for eta = 1 at
/// pi/2.
double iris_shift(double depth, double incidence, double eta);

/// Diameter of a human pupil in mm, [2, 7.75], by Stanley and Davies 1995 eq 4. `luminance` in cd/m^2, >= 0 and
/// infinite too; `field_degrees2` is the area of the adapting field in square degrees.
double pupil_diameter_mm(double luminance, double field_degrees2);

/// Share of the light on a spherical cornea that enters it, in [0, 1]: 1 - Fresnel averaged over the lit part of the
/// cap. `light_angle` in [0, pi] from the cap's axis, `half_angle` in (0, pi/2] of the cap seen from the sphere's
/// centre. 0 where no part of the cap is lit.
double cornea_transmittance(double light_angle, double half_angle, double eta);

/// Area of the cap's shadow seen from the light, over radius^2: what irradiance is multiplied with to give the light
/// that arrives. Same angles.
double cornea_cross_section(double light_angle, double half_angle);

/// The factor that makes a caustic carry just the light that came through the cornea: the sum of
/// weight x area x factor is `flux`. Same length, all >= 0. 0 where the weights reach no area.
double caustic_scale(double flux, std::span<const double> weights, std::span<const double> areas);

}  // namespace pelage
