// Frames that stand upright, for what is placed in a scene.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// Columns right, up and forward, unit and orthogonal; upright unless `forward` (of any length but 0) is nearly
/// vertical.
glm::dmat3 upright_frame(glm::dvec3 forward);

/// Turned around its third column, counter-clockwise as seen from its tip. Radians.
glm::dmat3 tilted(const glm::dmat3& frame, double angle);

}  // namespace pelage
