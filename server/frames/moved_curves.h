// Motion of whiskers and other curves in the wind and on a moving body.
#pragma once

#include "protocol/commands/wind.h"
#include "renderer/input/fur_scene.h"
#include "server/motion/sway.h"
#include "server/scene/scene.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns the motion of the skin under each curve of a group: that of the vertex at the curve's root.
BodyMotion motion_under(const FurCurves& curves, const Surface& surface, const BodySwing& swing);

/// Bends the curves of a group as the wind and the body have bent them at a time. Each curve is simulated as one
/// upright strand of the same length along it; its segments keep their lengths and turn more the nearer they are to the
/// tip. Curves are thicker than fur and therefore stiffer. Filled curves follow their guides. Without wind, nothing
/// moves on a still body. `body` is the result of motion_under, or null.
void sway_curves(FurCurves& curves, const Wind& wind, double moment, const BodyMotion* body = nullptr);

}  // namespace pelage
