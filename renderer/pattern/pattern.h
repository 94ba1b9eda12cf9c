// A coat's pattern: noise, markings and slow variation as pure functions of position and seed.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "protocol/commands/coat.h"

namespace pelage {

/// Returns gradient noise (Perlin 2002) with one period per unit: mean 0, standard deviation .19, seldom beyond +-.6.
float gradient_noise(glm::vec3 position, std::uint32_t stream, std::uint32_t seed);

/// Returns the distance along a surface with this unit normal to the nearest of points scattered one to a unit cell,
/// divided by the point's size, which is in [.8, 1.1] and falls to 0 for points half a unit off the surface. At most
/// .62.
float cell_distance(glm::vec3 position, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed);

// The constants of a coat's pattern, ready for evaluation.

struct PatternBlock {
  glm::uvec4 head{0};                                     // kind (number of PatternKind), seed
  glm::vec4 shape{0};                                     // markings per size, coverage, softness, warp
  glm::vec4 amounts{0};                                   // contrast, inner, legs, belly
  glm::vec4 axis{0};                                      // unit; w: 1 / the largest luminance of the ramp
  glm::vec4 colour{0}, inner_colour{0}, belly_colour{0};  // linear, darkened by the coat's wetness
  glm::vec4 variation{0};                                 // lightness, hue, length, lean
  glm::vec4 derived{0};  // periods of the variation per size; radius of spots and threshold of patches for the coverage

  bool operator==(const PatternBlock&) const = default;
};

PatternBlock make_pattern_block(const Coat& coat);

/// Returns true if colours or forms of this coat vary over the body; if not, shaders without a pattern are used.
bool has_pattern(const Coat& coat);

// Markings and slow variation over the body, as functions of the root's position (internal coordinates), without UVs.
// Shells read them from a volume (surface_volume.h) and from vertices: evaluating them in each fragment would cost more
// than everything else together.

/// Returns the weights of the belly's colour, the inner colour and the marking's colour, which are mixed in that order,
/// each in [0, 1].
glm::vec3 pattern_weights(const PatternBlock& block, glm::vec3 position, glm::vec3 normal);

/// Returns `base` with the colours mixed in by these weights. Same as in renderer/shaders/pattern.glsl.
glm::vec3 with_weights(const PatternBlock& block, glm::vec3 weights, glm::vec3 base);

/// Returns the slow variation at a position: factor on the length, addition to the inclination, factor on the
/// lightness, shift of the hue.
glm::vec4 pattern_variation(const PatternBlock& block, glm::vec3 position);

/// Returns the factor on the length of fur, [0, 2].
float pattern_length(const PatternBlock& block, glm::vec3 position);

/// Returns the addition to the inclination, [-1, 1]; the caller clamps the sum to [0, 1].
float pattern_lean(const PatternBlock& block, glm::vec3 position);

}  // namespace pelage
