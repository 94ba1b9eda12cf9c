// Whiskers and other curves in the wind.
#pragma once

#include "protocol/commands/wind.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Turns the curves of a group as the wind has bent them at a moment, each as one strand of the length of the curve
/// that stands as its root does: every piece of it keeps its length, and goes the further the nearer to the tip. They
/// are stiffer than fur, being thicker. `fill` follows. Nothing moves at speed 0.
void sway_curves(FurCurves& curves, const Wind& wind, double moment);

}  // namespace pelage
