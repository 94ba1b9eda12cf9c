// Upright local frames for objects placed in a scene, and eyes in the renderer's form.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/creature.h"
#include "renderer/input/fur_scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns an orthonormal frame with columns right, up and forward. Up is as close to +Y as `forward` allows. `forward`
/// has any length but 0 and may be vertical.
glm::dmat3 upright_frame(glm::dvec3 forward);

/// Rotates a frame around its third column by an angle in radians, counter-clockwise as seen from its tip.
glm::dmat3 tilted(const glm::dmat3& frame, double angle);

// Conversion of eyes for the renderer.

/// Returns an eye in internal coordinates. Its frame is upright as far as the gaze allows.
FurEye make_eye(const Eye& eye, const Mesh& mesh);

}  // namespace pelage
