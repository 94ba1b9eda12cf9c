// Things on a body other than fur: eyes, regions of bare skin and groups of guided curves.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace pelage {

enum class PupilShape { round, slit };

/// The coloured disc behind the cornea. Lengths are in radii of the eye.
struct Iris {
  glm::vec3 colour{0.42f, 0.115f, 0.014f};       // linear; tints the grey fibres
  glm::vec3 inner_colour{0.80f, 0.36f, 0.055f};  // linear; around the pupil
  double size = 0.78;                            // radius of the disc, [0.1, 0.95]
  double depth = 0.12;                           // depth of the disc below the cornea's rim, [0, 0.5]
  double relief = 0.06;                          // height of the fibres, clamped to the depth, [0, 0.2]
  double limbal_ring = 0.75;                     // darkness of the ring around it, [0, 1]
  double turn_degrees = 0;                       // rotation of the fibres around the axis, [-360, 360]

  bool operator==(const Iris&) const = default;
};

struct Pupil {
  PupilShape shape = PupilShape::round;
  std::optional<double> size = {};  // share of the iris, [0, 1]; none: it adapts to the light

  bool operator==(const Pupil&) const = default;
};

/// The opening between the lids: an almond on a sphere around the eye. Angles are seen from the eye's centre.
struct Lids {
  std::optional<glm::dvec3> facing = {};     // direction to its middle, model coordinates; none: the gaze
  double width_degrees = 64;                 // angle from the middle to a corner, [1, 90]
  double upper_degrees = 42;                 // angle from the middle to the upper lid, [-90, 90]
  double lower_degrees = 32;                 // angle from the middle to the lower lid, [-90, 90]
  double tilt_degrees = 0;                   // counter-clockwise as seen from the front, [-180, 180]
  glm::vec3 colour{0.018f, 0.013f, 0.011f};  // linear

  bool operator==(const Lids&) const = default;
};

/// A ball with a bulging cornea (science.md 5). A mammal's refractive index is 1.376.
struct Eye {
  glm::dvec3 position{0};                  // centre of the ball, model coordinates
  double radius = 0.02;                    // sizes, [1e-6, 1e6]
  glm::dvec3 gaze{0, 0, 1};                // direction in which it looks; any length but 0
  std::optional<glm::dvec3> look_at = {};  // a point that it looks at, instead of `gaze`; model coordinates
  Iris iris = {};
  Pupil pupil = {};
  std::optional<Lids> lids = {};
  glm::vec3 sclera{0.62f, 0.54f, 0.47f};  // linear
  double bulge = 0.5;                     // bulge of the cornea: 0 none, 1 half a ball, [0, 1]
  double refraction = 1.376;              // refractive index of the cornea, [1, 3]
  double wetness = 0.9;                   // how sharp the tear film reflects, [0, 1]

  bool operator==(const Eye&) const = default;
};

// Regions of bare skin in a scene, set by a command and logged: nose, lips, pads, inner ears.

/// Restricts a region to skin whose normal lies near a direction: the inside of an ear is bare while its back has fur.
struct SkinFacing {
  glm::dvec3 direction{0, 0, 1};  // any length but 0
  double angle_degrees = 70;      // largest angle from it at which the region has full effect, [0, 180]
  double fade_degrees = 25;       // further angle over which the effect fades out, [0, 180]

  bool operator==(const SkinFacing&) const = default;
};

/// Leathery relief: cells with creases between them.
struct SkinBumps {
  double height = 0.0004;  // sizes, [0, 0.1]
  double size = 0.004;     // size of a cell, sizes, [1e-4, 1]

  bool operator==(const SkinBumps&) const = default;
};

/// An ellipsoid: skin inside it has no fur and a look of its own. Where regions overlap, the later one covers the
/// earlier one.
struct SkinRegion {
  glm::dvec3 centre{0};      // model coordinates
  glm::dvec3 radii{0.05};    // sizes, [1e-6, 1e6]; the third along the axis
  glm::dvec3 axis{0, 0, 1};  // direction of the third radius, any length but 0; the first radius is horizontal
  double turn_degrees = 0;   // rotation around the axis, counter-clockwise as seen from its tip, [-180, 180]
  double softness = 0.5;     // width outside it over which fur grows to full length, in its radii, [0, 10]
  std::optional<SkinFacing> facing = {};
  glm::vec3 colour{0.36f, 0.17f, 0.13f};  // linear
  double shine = 0.5;                     // reflectance: 0.5 skin (4% head on), 1 twice that, [0, 1]
  double roughness = 0.5;                 // width of that highlight, [0.02, 1]
  double wetness = 0;                     // a clear film: darker, with a sharp highlight, [0, 1]
  double scatter = 0.5;                   // how far light wraps around, red the furthest, [0, 1]
  SkinBumps bumps = {};

  bool operator==(const SkinRegion&) const = default;
};

// Whiskers, lashes and brows: a few guided curves that are placed in a scene, set by a command and logged.

/// Points in model coordinates, root first, 2 to 32. The curve passes through them (Catmull and Rom 1974).
using GuideCurve = std::vector<glm::dvec3>;

/// Curves of one kind. Guides are drawn as they are given, and `fill` more curves are interpolated between each two
/// neighbours.
struct CurveGroup {
  std::vector<GuideCurve> curves;              // 1 to 4096 guides
  double width_root = 0.0008;                  // sizes, [0, 0.1]
  double width_tip = 0.0001;                   // sizes, [0, 0.1]
  glm::vec3 root_colour{0.55f, 0.50f, 0.44f};  // linear
  glm::vec3 tip_colour{0.80f, 0.77f, 0.72f};   // linear
  int fill = 0;                                // [0, 4095]
  double spread = 0;                           // how far filled curves stray in length, direction and position, [0, 1]
  std::uint32_t seed = 1;

  bool operator==(const CurveGroup&) const = default;
};

/// Returns the number of curves that a group draws: its guides and the filled ones.
inline std::uint64_t curve_count(const CurveGroup& group) {
  const std::uint64_t guides = group.curves.size();
  return guides == 0 ? 0 : guides + (guides - 1) * static_cast<std::uint64_t>(group.fill);
}

}  // namespace pelage
