// Maps of the light that shells let through, as a light sees them (GPU fur 3.1).
#pragma once

#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// The frame that a light sees, whose picture has the sides of its maps: from far away for one that is, so that a
/// camera can stand there. `radius`: of the ball about the origin that holds the fur, sizes; the light stands outside
/// it.
FurFrame frame_of_light(const FurFrame& frame, const FurLight& light, float radius);

/// Even shells, as many as maps have.
ShellSet shadow_shell_set();

/// Numbers of maps for a side.
std::size_t shell_map_numbers(int side);

}  // namespace pelage
