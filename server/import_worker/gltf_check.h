// Checks of what assimp takes on trust in glTF: container lengths, outside files, extensions, cycles; and of what it
// leaves out silently.
#pragma once

#include <string_view>

#include "base/status.h"
#include "server/import_worker/bundle.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Checks a GLB container: magic, version 2, its length, chunks within it, JSON first; then its document as check_gltf
/// does.
Status check_glb(std::string_view bytes, const Bundle& bundle, RawModel& model);

/// Refuses (invalid): text that is not JSON, another version than 2, buffers in files that are not bundled or in broken
/// base64 (naming them), required extensions that change the geometry or are not known (naming them), node graphs that
/// are no trees, and positions or texture coordinates that are not there. Counts among the model's losses: extensions
/// that are not read and change what is seen, pictures that are not there or that only an extension names, points and
/// lines, and primitives without positions. `binary_bytes` is the size of the GLB's chunk.
Status check_gltf(std::string_view json, const Bundle& bundle, RawModel& model, std::size_t binary_bytes = 0);

}  // namespace pelage
