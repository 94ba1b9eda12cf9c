// The corners that a place on the surface lies between.
#pragma once

#include <cstdint>
#include <vector>

#include "server/surface/surface.h"

namespace pelage {

/// The vertices that a place lies between: the corners of the triangle that holds it, of all such triangles on an edge,
/// and at a vertex that one alone. Queries name any triangle that holds a place; what starts here does not depend on
/// which.
std::vector<std::uint32_t> corners_around(const Surface& surface, const SurfacePoint& place);

}  // namespace pelage
