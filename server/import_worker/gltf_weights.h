// Weights of morph targets that nodes of a glTF give, which assimp passes over.
#pragma once

#include "server/import_worker/gltf_json.h"

namespace pelage {

/// A node's own weights take the place of its mesh's (glTF 2.0, 3.7.2.2): they move to the mesh, of which each such
/// node gets a copy that no other node has. The document is one that check_gltf takes.
void move_weights(gltf::json& root);

}  // namespace pelage
