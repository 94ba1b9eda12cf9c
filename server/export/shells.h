// Fur for viewers of glTF that know nothing of fur: the skin and layers of shells over it, baked.
#pragma once

#include <string>

#include "protocol/commands/export.h"
#include "server/export/strands.h"
#include "server/scene/scene.h"

namespace pelage {

struct BakedShells {
  std::string glb;
  std::uint64_t triangles = 0;
};

/// A GLB with a primitive for the skin, one for the eyes and one for each of request.shells layers, which lie along the
/// lean of the fur from its root to its tip, to be blended in their order. A layer's texture repeats the coat's sample
/// tile: how opaque its strands are, and how light; COLOR_0 is their colour, of the `strands`, darkened by those above,
/// and in alpha the density and the share of the patch. Positions are in the model's unit, on a node at the model's
/// centre.
Result<BakedShells> bake_shells(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request);

}  // namespace pelage
