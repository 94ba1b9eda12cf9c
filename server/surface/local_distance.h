// Distances along the surface around a point, for brushes.
#pragma once

#include <cstdint>
#include <vector>

#include "server/surface/surface.h"

namespace pelage {

struct VertexDistance {
  std::uint32_t vertex = 0;
  double distance = 0;  // sizes
};

/// Vertices at most `radius` from the point along the surface, rising. Fast marching that unfolds each triangle about
/// a virtual source (Novotni and Klein 2002): exact on flat parts, and never longer than the way along edges. It
/// marches one ring of vertices beyond the radius, and back from there. Cost follows the number found, not the mesh.
std::vector<VertexDistance> distances_within(const Surface& surface, const SurfacePoint& centre, double radius);

/// The distance of a place in a triangle whose other corners are `along` apart: `near` and `far` from them, which are
/// `near_distance` and `far_distance` from the source. Infinite where the straight way does not pass between them.
double unfolded_distance(double along, double near, double far, double near_distance, double far_distance);

}  // namespace pelage
