// Exports the eyes of a scene as plain balls, for viewers that do not draw corneas.
#pragma once

#include <vector>

#include "renderer/input/fur_scene.h"
#include "server/export/glb_writer.h"

namespace pelage {

/// Adds balls whose vertex colours show pupil, iris, sclera and lids. Positions are multiplied by `size` (model units
/// per size), like those of all other parts. Returns the primitive, with the material of that number; null if there are
/// no eyes. A pupil without a size is half as wide as the iris.
GltfJson add_eyes(GlbWriter& file, const std::vector<FurEye>& eyes, double size, int material);

}  // namespace pelage
