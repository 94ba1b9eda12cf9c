// What renderer/shaders/scattering.glsl reads besides the table: the numbers of a look, worked out once in double.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/look.h"

namespace pelage {

/// Mirrors ScatteringBlock of scattering.glsl, layout std140.
struct ScatteringBlock {
  glm::ivec4 model;      // ShadingModel by number; 1 where the absorption is given; 0; 0
  glm::vec4 weights;     // diffuse, specular, secondary specular, shift spread
  glm::vec4 exponents;   // diffuse, specular, secondary; 3 / colour polynomial: colour to absorption coordinate
  glm::vec4 shifts;      // primary, secondary, 0, 0
  glm::vec4 absorption;  // absorption coordinates where they are given; 0
  glm::vec4 tilt_sine;   // for each lobe: energy_conserving
  glm::vec4 tilt_cosine;
  glm::vec4 centre;      // for each lobe: theta_h of the peak, radians; marschner
  glm::vec4 variance;    // for each lobe: along the strand
  glm::vec4 normaliser;  // for each lobe: what the exponential is multiplied with; 0 for a lobe that is not there
};
static_assert(sizeof(ScatteringBlock) == 10 * 16);

ScatteringBlock scattering_block(const Look& look);

}  // namespace pelage
