// Where the built-in creature is bare.
#pragma once

#include <vector>

#include "protocol/commands/skin.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A wet nose, the line of the lips, pink inner ears and dark pads.
std::vector<SkinRegion> creature_skin(const Mesh& mesh);

}  // namespace pelage
