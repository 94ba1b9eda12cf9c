// A coat's pattern as plain numbers, ready to be evaluated.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/coat.h"

namespace pelage {

struct PatternBlock {
  glm::uvec4 head{0};                                     // kind (the order of PatternKind), seed
  glm::vec4 shape{0};                                     // markings per size, coverage, softness, warp
  glm::vec4 amounts{0};                                   // contrast, inner, legs, belly
  glm::vec4 axis{0};                                      // unit; w: 1 / the largest luminance of the ramp
  glm::vec4 colour{0}, inner_colour{0}, belly_colour{0};  // rgb, as the coat's wetness leaves them
  glm::vec4 variation{0};                                 // lightness, hue, length, lean
  glm::vec4 derived{0};  // swells per size, radius of spots and threshold of patches for the coverage

  bool operator==(const PatternBlock&) const = default;
};

PatternBlock make_pattern_block(const Coat& coat);

/// Whether colours or forms of this coat change with the place: programs without the pattern do where not.
bool has_pattern(const Coat& coat);

}  // namespace pelage
