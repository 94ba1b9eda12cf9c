// Bare skin that is placed in a scene: nose, lips, pads, inner ears. Part of it, set by a command and logged.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace pelage {

/// Restricts a region to skin whose normal lies near a direction, as an inner ear is bare and its back is furred.
struct SkinFacing {
  glm::dvec3 direction{0, 0, 1};  // any length but 0
  double angle_degrees = 70;      // from it, where the region is whole, [0, 180]
  double fade_degrees = 25;       // over which it ends beyond that, [0, 180]

  bool operator==(const SkinFacing&) const = default;
};

/// Leathery relief: cells with creases between them.
struct SkinBumps {
  double height = 0.0004;  // sizes, [0, 0.1]
  double size = 0.004;     // of a cell, sizes, [1e-4, 1]

  bool operator==(const SkinBumps&) const = default;
};

/// An ellipsoid: skin inside it has no fur and a look of its own. Where regions meet, the later lies over the earlier.
struct SkinRegion {
  glm::dvec3 centre{0};      // model coordinates
  glm::dvec3 radii{0.05};    // sizes, [1e-6, 1e6]; the third along the axis
  glm::dvec3 axis{0, 0, 1};  // any length but 0; the first radius lies level
  double turn_degrees = 0;   // around the axis, counter-clockwise as seen from its tip, [-180, 180]
  double softness = 0.5;     // how far outside it fur takes to be whole, in its radii, [0, 10]
  std::optional<SkinFacing> facing = {};
  glm::vec3 colour{0.36f, 0.17f, 0.13f};  // linear
  double shine = 0.5;                     // reflectance: 0.5 skin (4% head on), 1 twice that, [0, 1]
  double roughness = 0.5;                 // width of that highlight, [0.02, 1]
  double wetness = 0;                     // a clear film: darker, with a sharp highlight, [0, 1]
  double scatter = 0.5;                   // how far light wraps around, red the furthest, [0, 1]
  SkinBumps bumps = {};

  bool operator==(const SkinRegion&) const = default;
};

}  // namespace pelage
