// What assimp takes on trust in glTF: container lengths, outside files, extensions, cycles.
#pragma once

#include <string_view>

#include "protocol/base/status.h"

namespace pelage {

/// A GLB container: magic, version 2, its length, chunks within it, JSON first; then as check_gltf.
Status check_glb(std::string_view bytes);

/// Refuses (invalid): text that is not JSON, another version than 2, buffers and pictures in other files (naming the
/// URI), required extensions that change the geometry or are not known (naming them), node graphs that are no trees,
/// and positions or texture coordinates that are not 32-bit floats. `binary_bytes` is the size of the GLB's chunk.
Status check_gltf(std::string_view json, std::size_t binary_bytes = 0);

}  // namespace pelage
