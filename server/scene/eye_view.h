// Frames that stand upright, for what is placed in a scene.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/creature.h"
#include "renderer/input/fur_scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Columns right, up and forward, unit and orthogonal; upright unless `forward` (of any length but 0) is nearly
/// vertical.
glm::dmat3 upright_frame(glm::dvec3 forward);

/// Turns a frame around its third column by an angle in radians, counter-clockwise as seen from its tip.
glm::dmat3 tilted(const glm::dmat3& frame, double angle);

// Eyes as the renderer wants them.

/// Returns an eye in internal coordinates, with its frame upright as far as the gaze allows.
FurEye make_eye(const Eye& eye, const Mesh& mesh);

}  // namespace pelage
