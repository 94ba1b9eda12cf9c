// Markings of a coat and its slow changes over the body, as functions of where a strand's root is. Places are internal
// coordinates (y up, the nose at +z, the middle of the box at 0, its diagonal 1), so no model needs UVs.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

enum class PatternKind { none, stripes, spots, rosettes, tabby, patches, countershading };

/// One pattern. Colours are linear inside; markings lie on the coat's own colour, and both get lighter and darker along
/// the strand as the coat's ramp does.
struct Pattern {
  PatternKind kind = PatternKind::none;
  double scale = 0.07;       // from one marking to the next, sizes, [0.005, 2]
  double coverage = 0.5;     // share of the surface that is marked, [0, 1]; countershading: how far up it reaches
  double contrast = 1;       // how far markings replace the coat's colour, [0, 1]
  double softness = 0.15;    // width of a marking's edge over the marking's, [0, 1]
  double warp = 0.5;         // how far noise bends the markings, in distances from one to the next, [0, 2]
  double legs = 1;           // how far stripes turn to rings on legs and haunches, and rosettes fill there, [0, 1]
  double inner = 0;          // how far inner_colour is seen: in rosettes, as second patches, between stripes, [0, 1]
  double belly = 0;          // how far the underside takes belly_colour and loses its markings, [0, 1]
  glm::dvec3 axis{0, 0, 1};  // along which stripes follow each other; length in [1e-6, 1e6]
  glm::vec3 colour{0.012f, 0.010f, 0.009f};
  glm::vec3 inner_colour{0.22f, 0.10f, 0.035f};
  glm::vec3 belly_colour{0.75f, 0.70f, 0.62f};
  std::uint32_t seed = 1;

  bool operator==(const Pattern&) const = default;
};

/// How much colour and form change slowly over the body; amplitudes, each in [0, 1].
struct Variation {
  double lightness = 0;  // 1: from half to twice
  double hue = 0;        // 1: from a third towards blue to a third towards red
  double length = 0;     // 1: from none to twice
  double lean = 0;       // 1: the whole range of the inclination
  double size = 0.12;    // from one swell to the next, sizes, [0.005, 2]

  bool operator==(const Variation&) const = default;
};

}  // namespace pelage
