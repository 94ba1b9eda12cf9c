// Places on the sample tile after triangles were split.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "server/surface/mesh.h"
#include "server/patches/patches.h"

namespace pelage {

/// A triangle that came of another one: its corners, 0 to 2 those of the other, 3 to 5 the middles of its sides.
struct ChildTriangle {
  std::uint32_t parent = 0;
  std::array<std::uint8_t, 3> corners{0, 1, 2};
};

/// The map on the children of its triangles; they lie in the order of their parents. `refined` is their mesh.
PatchMap refine_patches(const PatchMap& map, const std::vector<ChildTriangle>& children, const Mesh& refined);

}  // namespace pelage
