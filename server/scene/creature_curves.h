// The whiskers, lashes and brows of the built-in creature.
#pragma once

#include <span>
#include <vector>

#include "protocol/commands/curves.h"
#include "protocol/commands/eye.h"
#include "server/surface/surface.h"

namespace pelage {

/// Two rows of whiskers and a few brow hairs on each side, rooted in the skin, and lashes along the upper lids of the
/// eyes.
std::vector<CurveGroup> creature_curves(const Surface& surface, std::span<const Eye> eyes);

}  // namespace pelage
