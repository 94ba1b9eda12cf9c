// Triangles of shells that reach behind the camera, cut where they come too near.
#pragma once

#include <vector>

#include "renderer/marched/march_scene.h"

namespace pelage {

/// What of a triangle lies beyond the near plane, as triangles of rows that are added to the scene: one or two. Some of
/// its corners lie before the plane and some behind.
std::vector<ShellTriangle> cut_at_near_plane(MarchScene& scene, const ShellTriangle& triangle);

}  // namespace pelage
