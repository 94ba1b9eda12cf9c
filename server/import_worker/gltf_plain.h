// Rewrites features of glTF that assimp does not read by ones that it does.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "server/import_worker/bundle.h"

namespace pelage {

/// A document, checked by gltf_check, in which plain glTF replaces
///  - weights of a node (a mesh of its own for each such node),
///  - numbers that are no 32-bit floats (KHR_mesh_quantization, and what the core allows),
///  - KHR_texture_transform of the base colour (other texture coordinates),
///  - KHR_materials_pbrSpecularGlossiness (a base colour), and
///  - EXT_mesh_gpu_instancing (nodes).
/// Documents without these are not changed. Refused (invalid): attributes that reach beyond their buffers, and too many
/// instances.
struct PlainGltf {
  std::string bytes;          // the document, or the GLB
  std::size_t bad_faces = 0;  // faces with an index that no vertex has, which assimp drops silently
};

/// `binary` is the binary chunk of a GLB.
Result<PlainGltf> plain_gltf(std::string document, const Bundle& bundle, std::string_view binary = {});

/// The same for a GLB.
Result<PlainGltf> plain_glb(std::string bytes, const Bundle& bundle);

}  // namespace pelage
