// Bakes fur for glTF viewers that do not draw fur: the skin, and textured shells over it.
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

/// Makes a GLB with a primitive for the skin, one for each of request.shells shells of each coat of the strands, and
/// one for the eyes. Shells follow the lean of the fur from root to tip; they have to be blended in their order, which
/// is from the skin outwards. A shell's material is named after the coat; its texture repeats the coat's sample tile:
/// opacity and lightness of its strands. COLOR_0 is the colour of the `strands`, darkened by those above; its alpha is
/// the density times the share of the patch. Positions are in the model's unit, on a node at the model's centre.
Result<BakedShells> bake_shells(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request);

}  // namespace pelage
