// Optics of the eye: refraction at the cornea, the pupil's reaction to light, the surfaces of the eye, caustics on the
// iris, and the block that shaders read.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// Returns the refracted direction of a ray by Snell's law. `along` and `normal` are unit, the normal on the side that
/// the ray comes from; `index` > 0 is that of the inside over that of the outside. None for total internal reflection,
/// which needs an index below 1 (GLSL's refract returns a zero vector there: science.md 5).
std::optional<glm::dvec3> refract_into(glm::dvec3 along, glm::dvec3 normal, double index);

/// Returns the share of unpolarised light that is reflected (Fresnel), [0, 1]. `cosine`: to the normal, [0, 1]; `index`
/// >= 1.
double fresnel(double cosine, double index);

/// Returns the diameter of the pupil over that of the iris, [0.17, 0.68], for an eye that sees a luminance >= 0, in
/// candela per square metre (Moon and Spencer 1944: 4.9 - 3 tanh(.4 log10 L) mm; an iris of 11.8 mm).
double pupil_size(double luminance);

// The surfaces of an eye, in its own frame: the ball has radius 1 around the origin; the eye looks along +Z.

struct EyeShape {
  double iris_radius = 0;    // also that of the limbus, where cornea and ball meet
  double limbus = 0;         // z of the limbus
  double cornea_centre = 0;  // z
  double cornea_radius = 1;
  double iris_plane = 0;  // z of the bottom of the iris
  double relief = 0;      // height of the iris fibres above that
  double refraction = 1;

  bool operator==(const EyeShape&) const = default;
};

EyeShape shape_of(const FurEye& eye);

/// Semi-axes of the pupil over the radius of the iris, [0, 1] each.
struct PupilAxes {
  double width = 0, height = 0;
};
/// Returns the axes for a pupil of a size in [0, 1]. A slit gets rounder as it dilates; at 1 it is round too.
PupilAxes pupil_axes(PupilShape shape, double size);

/// Returns the luminance that an eye sees, in candela per square metre: a light of intensity 1 in front of it counts as
/// 1000.
double luminance_at(const FurEye& eye, const FurFrame& frame);

// Caustics of the cornea on the iris behind it.

/// Returns for each angle a map, row by row, of the irradiance on the plane of the iris over that of a surface that
/// faces the light. The light comes from +X. Energy is preserved: the sum over texels times a texel's area is the flux
/// that comes through the cornea and reaches the iris (science.md 5).
std::vector<float> gather_caustics(const EyeShape& shape);

// The eyes of a frame, in the layout (std430) that renderer/optics and renderer/shaders/eyes.glsl read.

struct EyeEntry {
  glm::vec4 right{0}, up{0}, forward{0}, position{0}, cornea{0}, iris{0}, inner{0}, pupil{0}, sclera{0};
  glm::vec4 lid_right{0}, lid_up{0}, lid_facing{0}, lid{0};
};

struct EyeBlock {
  glm::vec4 surroundings{0};
  std::array<EyeEntry, max_eyes> eyes{};
};
static_assert(sizeof(EyeBlock) == 16 * (1 + 8 * 13));

/// `first_caustic`: number of the first caustic map of the eye's shape. A pupil without a size reacts to the frame's
/// lights.
EyeEntry make_eye_entry(const FurEye& eye, const FurFrame& frame, int first_caustic);

}  // namespace pelage
