// Light at the cornea, and the pupil that answers it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace pelage {

/// The direction inside of a ray that comes from air, by Snell's law. `along` and `normal` are unit, the normal on the
/// side that the ray comes from; `index` is that of the inside over that outside, above 0. None where all light is
/// reflected, which needs an index below 1 (GLSL's refract answers a zero vector there: science.md 5).
std::optional<glm::dvec3> refract_into(glm::dvec3 along, glm::dvec3 normal, double index);

/// Share of unpolarised light that is reflected (Fresnel), [0, 1]. `cosine` is of the angle to the normal, [0, 1];
/// `index` is at least 1.
double fresnel(double cosine, double index);

/// Diameter of a pupil over that of the iris, [0.17, 0.68], for an eye that sees the luminance, in candela per square
/// metre, at least 0 (Moon and Spencer 1944: 4.9 - 3 tanh(.4 log10 L) mm; an iris of 11.8 mm).
double pupil_size(double luminance);

}  // namespace pelage
