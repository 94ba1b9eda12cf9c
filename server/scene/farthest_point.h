// Finds the position of a surface that lies farthest along a direction within a box, such as the tip of an ear.
#pragma once

#include <optional>

#include "protocol/commands/pick.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns the farthest position along the wanted direction inside the box; of several equally far ones, that on the
/// first triangle. Returns nothing if no triangle reaches into the box.
std::optional<SurfacePoint> farthest_point(const Surface& surface, const PickFarthest& wanted);

}  // namespace pelage
