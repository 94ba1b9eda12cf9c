// Noise that is a pure function of place, stream and seed, the same on CPU and GPU (renderer/shaders/pattern.glsl).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "protocol/commands/coat.h"

namespace pelage {

/// Gradient noise (Perlin 2002) of one swell per unit: mean 0, standard deviation .19, seldom beyond +-.6.
float gradient_noise(glm::vec3 place, std::uint32_t stream, std::uint32_t seed);

/// Distance along a surface of this normal (unit) to the nearest of points scattered one to a unit cell, over the
/// point's own size: in [.8, 1.1], shrinking to nothing for points half a unit off the surface. At most .62.
float cell_distance(glm::vec3 place, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed);

// A coat's pattern as plain numbers, ready to be evaluated.

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

/// Returns whether colours or forms of this coat change with the place: programs without the pattern do where not.
bool has_pattern(const Coat& coat);

// Markings and slow changes over the body. They are functions of the root's place (internal coordinates) and need no
// UVs. Shells read them from a volume (surface_volume.h) and from vertices: evaluated in each fragment they would cost
// more than all else together.

/// Shares of the belly's colour, of the inner colour and of the marking's, mixed in that order, each in [0, 1].
glm::vec3 pattern_weights(const PatternBlock& block, glm::vec3 place, glm::vec3 normal);

/// `base` with these shares mixed in. renderer/shaders/pattern.glsl has the same.
glm::vec3 with_weights(const PatternBlock& block, glm::vec3 weights, glm::vec3 base);

/// Slow changes at a place: factor on the length, addition to the inclination, factor on the lightness, turn of the
/// hue.
glm::vec4 pattern_variation(const PatternBlock& block, glm::vec3 place);

/// Factor on the length of fur, [0, 2].
float pattern_length(const PatternBlock& block, glm::vec3 place);

/// To be added to the inclination, [-1, 1]; the sum is clamped to [0, 1] by who adds it.
float pattern_lean(const PatternBlock& block, glm::vec3 place);

}  // namespace pelage
