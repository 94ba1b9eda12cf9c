// Whiskers and other curves in the wind and on a body that moves.
#pragma once

#include "protocol/commands/wind.h"
#include "renderer/input/fur_scene.h"
#include "server/motion/sway.h"
#include "server/scene/scene.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns the motion of the skin under each curve of a group: that of the vertex at the curve's root.
BodyMotion motion_under(const FurCurves& curves, const Surface& surface, const BodySwing& swing);

/// Turns the curves of a group as the wind and the body have bent them at a moment, each as one strand of the length of
/// the curve that stands as its root does: every piece of it keeps its length, and goes the further the nearer to the
/// tip. They are stiffer than fur, being thicker. `fill` follows. Nothing moves at speed 0 on a body that rests.
/// `body`: motion_under, or null.
void sway_curves(FurCurves& curves, const Wind& wind, double moment, const BodyMotion* body = nullptr);

}  // namespace pelage
