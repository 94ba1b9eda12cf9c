// The surfaces of an eye, in its own frame: the ball has radius 1 around the origin, and it looks along +Z.
#pragma once

#include "renderer/input/fur_scene.h"

namespace pelage {

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

}  // namespace pelage
