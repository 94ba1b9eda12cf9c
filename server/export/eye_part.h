// The eyes of a scene as plain balls, for viewers that know nothing of corneas.
#pragma once

#include <vector>

#include "renderer/input/fur_scene.h"
#include "server/export/glb_writer.h"

namespace pelage {

/// Adds balls with pupil, iris, white and the opening of the lids as colours of their vertices, `size` model units a
/// size, in the same place as all other parts. The primitive with the material of that number; null where there are
/// no eyes. Without a size a pupil is half as wide as the iris.
GltfJson add_eyes(GlbWriter& file, const std::vector<FurEye>& eyes, double size, int material);

}  // namespace pelage
