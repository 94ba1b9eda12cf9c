// Exports fur as hair cards, as games draw it: textured strips along its clumps, in levels of detail.
#pragma once

#include <string>

#include "protocol/commands/export.h"
#include "server/export/strands.h"
#include "server/scene/scene.h"

namespace pelage {

inline constexpr int card_levels = 3;

struct CardFile {
  std::string glb;
  std::uint64_t triangles = 0;  // of the skin and the finest level
  std::uint64_t cards = 0;      // of the finest level
};

/// Makes a GLB with a scene for each level of detail; "LOD0" is the finest and first. A scene has the skin with the
/// eyes, and one mesh of cards ("fur_LOD0") with a primitive and a material for each coat, named after it. The finest
/// level has about request.cards cards, the next ones a half and a quarter of that, wider and with fewer rows. A card
/// follows the mean strand of a clump, and lies flat on the fur except for a random turn. Its texture has an alpha
/// cutoff of .4; COLOR_0 is the colour of the `strands`, darker where fur shades it, NORMAL that of the skin. Whiskers
/// are left out.
Result<CardFile> bake_cards(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request);

}  // namespace pelage
