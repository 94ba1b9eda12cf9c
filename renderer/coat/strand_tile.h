// The fur texture generator: the strands of one periodic sample tile (fur modelling 4). Slices and, later, traced
// strands are both made from them.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "protocol/commands/coat.h"

namespace pelage {

/// The length of fur that bend and curl are made for, in sizes.
inline constexpr double nominal_length = 0.03;

/// One strand. Places are in sizes on the tile, before the lean; they may leave [0, tile) and are taken modulo the tile.
struct Strand {
  glm::dvec2 root{0};
  glm::dvec2 clump{0};     // from the root to the middle of its clump
  glm::dvec2 bow{0};       // offset of the tip by bending
  double curl_phase = 0;   // radians
  double length_share = 1; // of the field's length, (0, 1]
  double lightness = 1;    // factor on the ramp's colour
  double number = 0;       // uniform in [0, 1): kept while below the density
};

/// Deterministic in the coat alone.
std::vector<Strand> make_strands(const Coat& coat);

/// Offset from the root at `q` in [0, 1] along the strand, sizes.
glm::dvec2 strand_offset(const Coat& coat, const Strand& strand, double q);

/// The coat's ramp at `q` in [0, 1], linear colour.
glm::vec3 ramp_colour(const Coat& coat, double q);

}  // namespace pelage
