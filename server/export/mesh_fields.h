// Exports the skin with the fields of its fur, for shaders of other programs.
#pragma once

#include <string>

#include "server/export/strands.h"
#include "server/scene/scene.h"

namespace pelage {

struct MeshFile {
  std::string glb;
  std::uint64_t triangles = 0;
};

/// Makes a GLB with one primitive: POSITION and lengths in the model's unit on a node at the model's centre, NORMAL,
/// TEXCOORD_0 (position on the coat's sample tile, which repeats), COLOR_0 (linear, the mean of the fur) and for each
/// scalar field an attribute of its name (_LENGTH, _DENSITY ...). _DIRECTION is the vector along the skin to which the
/// fur leans; its length is the inclination. _WEIGHT is the share of a patch where patches overlap. The material's
/// occlusion texture (of strength 0) is an atlas of 4 x 4 shell textures of the tile, from the roots up; `extras` of
/// the mesh give its size.
Result<MeshFile> export_mesh(const SceneView& scene, const ExportedStrands& strands);

}  // namespace pelage
