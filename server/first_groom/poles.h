// Where the fur of a body begins and where it ends: under the chin, and at the ends of limbs, ears and tail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A place that fur flows out of (above 0) or into.
struct Pole {
  std::uint32_t vertex = 0;
  double flux = 0;
};

/// Of one connected part, that looks along +Z: fur begins under its chin, near what lies farthest forward and up, at
/// its lowest there; it ends wherever the way along edges from there is longer than all around by a tenth of a size,
/// on the side that shows least. Their fluxes sum to 0; equal places on both sides of the middle share one. Empty for a
/// part without an end. `part` are its vertices.
std::vector<Pole> find_poles(const Mesh& mesh, const Adjacency& edges, std::span<const std::uint32_t> part);

}  // namespace pelage
