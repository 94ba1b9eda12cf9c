// Markings and slow changes over the body on the CPU: for traced strands and tests. The GPU has the same formulas in
// renderer/shaders/pattern.glsl, names included. Places are internal coordinates of the strand's root.
#pragma once

#include <glm/glm.hpp>

#include "renderer/pattern/pattern_block.h"

namespace pelage {

/// The colour of a strand whose root is at `place` with this normal (unit) and which would be `base` (linear) without a
/// pattern. Markings get lighter and darker along the strand as the base does. The base itself where there is none.
glm::vec3 pattern_colour(const PatternBlock& block, glm::vec3 place, glm::vec3 normal, glm::vec3 base);

/// How far the marking covers the place and how far the inner colour does, each in [0, 1].
glm::vec2 pattern_marks(const PatternBlock& block, glm::vec3 place, glm::vec3 normal);

/// Factor on the length of fur, [0, 2].
float pattern_length(const PatternBlock& block, glm::vec3 place);

/// To be added to the inclination, [-1, 1]; the sum is clamped to [0, 1] by who adds it.
float pattern_lean(const PatternBlock& block, glm::vec3 place);

}  // namespace pelage
