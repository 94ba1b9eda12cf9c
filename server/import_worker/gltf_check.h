// Checks what assimp does not check in glTF (container lengths, external files, extensions, cycles), and counts what it
// leaves out silently.
#pragma once

#include <string_view>

#include "base/status.h"
#include "server/import_worker/bundle.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Checks a GLB container (magic, version 2, length, chunks within it, JSON first), then its document by check_gltf.
Status check_glb(std::string_view bytes, const Bundle& bundle, RawModel& model);

/// Refuses (invalid): text that is not JSON, another version than 2, buffers in files that are not bundled or in broken
/// base64 (naming them), required extensions that change the geometry or are unknown (naming them), node graphs that
/// are no forests, documents without a scene, and missing accessors of positions or texture coordinates. Counts among
/// the model's losses: unread extensions that change the look, pictures that are missing or that only an extension
/// names, points and lines, and primitives without positions. `binary_bytes` is the size of the GLB's binary chunk.
Status check_gltf(std::string_view json, const Bundle& bundle, RawModel& model, std::size_t binary_bytes = 0);

}  // namespace pelage
