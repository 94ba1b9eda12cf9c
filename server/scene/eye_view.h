// Eyes as the renderer wants them.
#pragma once

#include "protocol/commands/eye.h"
#include "renderer/input/fur_scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// In internal coordinates, with its frame upright as far as the gaze allows.
FurEye make_eye(const Eye& eye, const Mesh& mesh);

}  // namespace pelage
