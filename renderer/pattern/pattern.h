// Markings and slow changes over the body. They are functions of the root's place (internal coordinates) and need no
// UVs. Shells read them from a volume (pattern_volume.h) and from vertices: evaluated in each fragment they would cost
// more than all else together.
#pragma once

#include <glm/glm.hpp>

#include "renderer/pattern/pattern_block.h"

namespace pelage {

/// The colour of a strand whose root is at `place` with this normal (unit) and which would be `base` (linear) without a
/// pattern. Markings get lighter and darker along the strand as the base does. The base itself where there is none.
glm::vec3 pattern_colour(const PatternBlock& block, glm::vec3 place, glm::vec3 normal, glm::vec3 base);

/// Shares of the belly's colour, of the inner colour and of the marking's, mixed in that order, each in [0, 1].
glm::vec3 pattern_weights(const PatternBlock& block, glm::vec3 place, glm::vec3 normal);

/// `base` with these shares mixed in. renderer/shaders/pattern.glsl has the same.
glm::vec3 with_weights(const PatternBlock& block, glm::vec3 weights, glm::vec3 base);

/// Slow changes at a place: factor on the length, addition to the inclination, factor on the lightness, turn of the
/// hue.
glm::vec4 pattern_variation(const PatternBlock& block, glm::vec3 place);

/// How far the marking covers the place and how far the inner colour does, each in [0, 1].
glm::vec2 pattern_marks(const PatternBlock& block, glm::vec3 place, glm::vec3 normal);

/// Factor on the length of fur, [0, 2].
float pattern_length(const PatternBlock& block, glm::vec3 place);

/// To be added to the inclination, [-1, 1]; the sum is clamped to [0, 1] by who adds it.
float pattern_lean(const PatternBlock& block, glm::vec3 place);

}  // namespace pelage
