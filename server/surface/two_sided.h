// Sheets of one layer that grow fur on both sides: an ear, a wing, a leaf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "server/surface/faces.h"
#include "server/surface/mesh.h"
#include "server/surface/weld.h"

namespace pelage {

/// How far the two sides lie apart, sizes: less than a strand's width, and enough that neither shows through the other.
inline constexpr double sheet_thickness = 1e-3;

/// Appends a copy of the parts in `numbers`, from 1, with vertices of their own and wound the other way. Gives the
/// number of vertices before them.
std::size_t add_backs(Soup& soup, const Orientation& orientation, const std::vector<std::uint32_t>& numbers);

/// Moves the vertices from `first` on by sheet_thickness along their normals, away from the sides that they are copies
/// of.
void lift_backs(Mesh& mesh, std::size_t first);

}  // namespace pelage
