// What of a mesh's fur may be seen in a part of the picture, so that a stroke's part does not pay for all of it.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/marched/march_scene.h"

namespace pelage {

/// Triangles of the scene's mesh whose fur may touch the tiles of its box or reach behind the camera, in their order.
/// By balls about the roots, so some are too many; none is missing.
std::vector<std::uint32_t> pieces_in_box(const MarchScene& scene);

}  // namespace pelage
