// Eyes that are placed in a scene: part of it, set by a command and logged.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace pelage {

enum class PupilShape { round, slit };

/// The coloured disc behind the cornea. Lengths are in radii of the eye.
struct Iris {
  glm::vec3 colour{0.42f, 0.115f, 0.014f};       // linear; tints the grey fibres
  glm::vec3 inner_colour{0.80f, 0.36f, 0.055f};  // linear; around the pupil
  double size = 0.78;                            // radius of the disc, [0.1, 0.95]
  double depth = 0.12;                           // of the disc below the cornea's rim, [0, 0.5]
  double relief = 0.06;                          // height of the fibres, at most the depth, [0, 0.2]
  double limbal_ring = 0.75;                     // darkness of the ring around it, [0, 1]
  double turn_degrees = 0;                       // of the fibres around the axis, [-360, 360]

  bool operator==(const Iris&) const = default;
};

struct Pupil {
  PupilShape shape = PupilShape::round;
  std::optional<double> size = {};  // share of the iris, [0, 1]; none: answers the light

  bool operator==(const Pupil&) const = default;
};

/// What the lids leave open: an almond on a sphere around the eye. Angles are seen from the eye's centre.
struct Lids {
  std::optional<glm::dvec3> facing = {};     // middle of the opening, model coordinates; none: where the eye looks
  double width_degrees = 64;                 // from the middle to a corner, [1, 90]
  double upper_degrees = 42;                 // from the middle to the upper lid, [-90, 90]
  double lower_degrees = 32;                 // from the middle to the lower lid, [-90, 90]
  double tilt_degrees = 0;                   // counter-clockwise as seen from the front, [-180, 180]
  glm::vec3 colour{0.018f, 0.013f, 0.011f};  // linear

  bool operator==(const Lids&) const = default;
};

/// A ball with a bulging cornea (science.md 5). A mammal's refractive index is 1.376.
struct Eye {
  glm::dvec3 position{0};                  // of the ball's centre, model coordinates
  double radius = 0.02;                    // sizes, [1e-6, 1e6]
  glm::dvec3 gaze{0, 0, 1};                // where it looks; any length but 0
  std::optional<glm::dvec3> look_at = {};  // a point that it looks at, in place of the gaze
  Iris iris = {};
  Pupil pupil = {};
  std::optional<Lids> lids = {};
  glm::vec3 sclera{0.62f, 0.54f, 0.47f};  // linear
  double bulge = 0.5;                     // of the cornea: 0 none, 1 half a ball, [0, 1]
  double refraction = 1.376;              // index of the cornea, [1, 3]
  double wetness = 0.9;                   // how sharp the tear film reflects, [0, 1]

  bool operator==(const Eye&) const = default;
};

}  // namespace pelage
