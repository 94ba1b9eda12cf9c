// What water does to a coat beside gathering its clumps. Each factor is 1 for a dry coat.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/coat.h"
#include "protocol/commands/look.h"

namespace pelage {

/// Factor on a fibre's absorption, 1 to 1.8: light that water keeps inside crosses more pigment. A colour c is then
/// c^factor, which darkens it and makes it more saturated.
inline double wet_absorption(const Coat& coat) { return 1 + 0.8 * coat.wetness; }

/// Factor on the weight of the highlight, 1 to 2: a film of water is smoother than the scales under it.
inline double wet_shine(const Coat& coat) { return 1 + coat.wetness; }

/// Factor on the exponent of the highlight (one over the square of its width), 1 to 3.
inline double wet_sharpness(const Coat& coat) { return 1 + 2 * coat.wetness; }

/// Factor on a fibre's roughness along it, .5 to 1: water fills the steps between its scales.
inline double wet_roughness(const Coat& coat) { return 1 - 0.5 * coat.wetness; }

/// A look as the coat's wetness leaves it: shinier, with sharper highlights.
inline Look wet_look(const Coat& coat, Look look) {
  look.specular *= wet_shine(coat);
  look.specular_exponent *= wet_sharpness(coat);
  look.fibre.longitudinal_roughness *= wet_roughness(coat);
  return look;
}

/// A linear colour as the coat's wetness leaves it.
inline glm::vec3 wet_colour(const Coat& coat, glm::vec3 colour) {
  return coat.wetness > 0 ? glm::pow(colour, glm::vec3(static_cast<float>(wet_absorption(coat)))) : colour;
}

}  // namespace pelage
