// From a flattened patch to the points of a map.
#pragma once

#include <vector>

#include "server/patches/patches.h"

namespace pelage {

/// Points of all vertices of `flat`, in their order, at weight 0. The axis is the mean of its triangles' around a
/// vertex; where there is none, the vertex's tangent.
std::vector<PatchPoint> make_points(const Mesh& mesh, const FlatPatch& flat, std::uint32_t patch);

}  // namespace pelage
