// Finds what of a surface lies farthest along a direction within a box, such as the tip of an ear.
#pragma once

#include <optional>

#include "protocol/commands/pick.h"
#include "server/surface/surface.h"

namespace pelage {

/// Finds the farthest position in the wanted direction inside the box; if several are equally far, the one on the first
/// triangle. Returns nothing if no triangle reaches into the box.
std::optional<SurfacePoint> farthest_place(const Surface& surface, const PickFarthest& wanted);

}  // namespace pelage
