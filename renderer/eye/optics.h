// Light at the cornea, and the pupil that answers it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

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

// The surfaces of an eye, in its own frame: the ball has radius 1 around the origin, and it looks along +Z.

struct EyeShape {
  double iris_radius = 0;    // also that of the limbus, where cornea and ball meet
  double limbus = 0;         // z of the limbus
  double cornea_centre = 0;  // z
  double cornea_radius = 1;
  double iris_plane = 0;  // z of the bottom of the iris
  double relief = 0;      // height of its fibres above that
  double refraction = 1;

  bool operator==(const EyeShape&) const = default;
};

EyeShape shape_of(const FurEye& eye);

/// Semi-axes of the pupil over the radius of the iris, [0, 1] each.
struct PupilAxes {
  double width = 0, height = 0;
};
/// A slit opens to a round pupil; both are round when they are full.
PupilAxes pupil_axes(PupilShape shape, double size);

/// Luminance that an eye sees, in candela per square metre: a light of intensity 1 in front of it stands for 1000.
double luminance_at(const FurEye& eye, const FurFrame& frame);

// Light that a cornea gathers on the iris behind it.

/// For each angle, row by row, the irradiance on the plane of the iris over that of a surface which faces the light.
/// The light comes from +X. What comes through the cornea and reaches the iris is all there: the sum over texels times
/// a texel's area is the flux (science.md 5).
std::vector<float> gather_caustics(const EyeShape& shape);

// The eyes of a frame, as renderer/optics and, std430, renderer/shaders/eyes.glsl read them.

struct EyeEntry {
  glm::vec4 right{0}, up{0}, forward{0}, position{0}, cornea{0}, iris{0}, inner{0}, pupil{0}, sclera{0};
  glm::vec4 lid_right{0}, lid_up{0}, lid_facing{0}, lid{0};
};

struct EyeBlock {
  glm::vec4 surroundings{0};
  std::array<EyeEntry, max_eyes> eyes{};
};
static_assert(sizeof(EyeBlock) == 16 * (1 + 8 * 13));

/// `first_caustic` is the array index at which the caustics of the eye's shape begin. A pupil without a size answers
/// the frame's lights.
EyeEntry make_eye_entry(const FurEye& eye, const FurFrame& frame, int first_caustic);

}  // namespace pelage
