// The strands of a coat seen from the side: the picture on fins (Lengyel 2001, "Real-time fur over arbitrary
// surfaces").
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

inline constexpr int side_view_width = 512;   // texels along the tile's side; periodic
inline constexpr int side_view_height = 128;  // texels from root to tip

/// How thick the slab of fur is that the side view shows, over the tile's side.
inline constexpr double side_view_depth = 1.0 / 128;

/// Colour times opacity (linear) and opacity in [0, 1], x fastest, the roots' row first. Strands of the slab are drawn
/// from far to near; one that is thinner than a texel keeps its area. Deterministic in the coat alone.
std::vector<glm::vec4> bake_side_view(const Coat& coat);

}  // namespace pelage
