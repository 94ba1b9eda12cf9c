// Bare skin as the renderer wants it.
#pragma once

#include <vector>

#include "protocol/commands/skin.h"
#include "renderer/input/fur_scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// In internal coordinates, in the same order.
std::vector<FurSkinRegion> make_skin(const std::vector<SkinRegion>& regions, const Mesh& mesh);

}  // namespace pelage
