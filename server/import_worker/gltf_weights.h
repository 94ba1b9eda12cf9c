// Weights of morph targets that nodes of a glTF give, which assimp passes over.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// A node's own weights take the place of its mesh's (glTF 2.0, 3.7.2.2): the document with them in the meshes, each of
/// such a node in a copy that no other node has. As it was where no node gives any. The document is one that
/// check_gltf takes.
std::string with_node_weights(std::string document);

/// The same within a GLB that check_glb takes.
std::string with_node_weights_of_glb(std::string bytes);

}  // namespace pelage
