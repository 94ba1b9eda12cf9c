// The whiskers, lashes and brows of the built-in creature.
#pragma once

#include <span>
#include <vector>

#include "protocol/commands/creature.h"
#include "server/scene/scene.h"
#include "server/surface/mesh.h"
#include "server/surface/surface.h"

namespace pelage {

/// Two rows of whiskers and a few brow hairs on each side, rooted in the skin, and lashes along the upper lids of the
/// eyes.
std::vector<CurveGroup> creature_curves(const Surface& surface, std::span<const Eye> eyes);

// Where the built-in creature is bare.

/// A wet nose, the line of the lips, pink inner ears and dark pads.
std::vector<SkinRegion> creature_skin(const Mesh& mesh);

// What a scene begins with beside its fur.

/// The default coat, look and lights; the built-in creature has two eyes, whiskers, lashes, brows and bare skin. The
/// ground is visible where it is asked for.
SceneSettings first_settings(const SceneModel& model, bool ground = false);

}  // namespace pelage
