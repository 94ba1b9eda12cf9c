// The settings of a new scene: default coat, look and lights, and the built-in creature's eyes, whiskers, lashes, brows
// and bare skin.
#pragma once

#include <span>
#include <vector>

#include "protocol/commands/creature.h"
#include "server/scene/scene.h"
#include "server/surface/mesh.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns two rows of whiskers and a few brow hairs for each side of the head, rooted in the skin, and lashes along
/// the upper lids of the eyes.
std::vector<CurveGroup> creature_curves(const Surface& surface, std::span<const Eye> eyes);

// The bare skin of the built-in creature.

/// Returns the regions of bare skin: a wet nose, the lips, pink inner ears and dark pads.
std::vector<SkinRegion> creature_skin(const Mesh& mesh);

// The settings of a new scene.

/// Returns the default coat, look and lights. The built-in creature also gets two eyes, whiskers, lashes, brows and
/// bare skin. `ground` makes the ground visible.
SceneSettings first_settings(const SceneModel& model, bool ground = false);

}  // namespace pelage
