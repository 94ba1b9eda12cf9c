// Triangulation of polygons, and consistent orientation of the resulting parts.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/weld.h"

namespace pelage {

/// Triangulates a polygon. Returns triangles as indices of its corners, with the polygon's winding. Consecutive corners
/// on the same vertex count once. Convex polygons become a fan, quads are split at the shorter diagonal that lies
/// inside, and others are triangulated by ear clipping. Non-convex polygons of more than 128 corners become a fan too,
/// so that no file takes cubic time. Triangles without area are left out. The scale of `positions` is about 1.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const std::uint32_t> vertices,
                                                      const std::vector<glm::dvec3>& positions);

/// Returns whether the height of the triangle is below rounding.
bool has_no_area(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

// Orientation of the parts of a mesh.

/// A part: triangles connected by edges that exactly two triangles share.
struct OrientedPart {
  std::uint32_t first = 0;  // lowest triangle number
  std::size_t triangles = 0;
  Placement box;
  bool doubtful = false;  // ModelReport::doubtful_parts
  bool sheet = false;     // has open edges, and encloses almost no volume
};

struct Orientation {
  std::size_t flipped_triangles = 0;
  std::size_t open_edges = 0;          // edges of one triangle
  std::size_t non_manifold_edges = 0;  // edges of three or more triangles
  std::size_t one_sided_edges = 0;     // edges across which the winding cannot be consistent, as on a Moebius strip
  std::vector<OrientedPart> parts;     // in the order of their first triangles
  std::vector<std::uint32_t> part_of;  // for each triangle, its index in `parts`
};

/// Flips triangles so that the winding is consistent across each edge of two triangles. A part without open edges then
/// encloses a positive signed volume. So does a part that is nearly closed, as a scan is: one whose holes, covered by
/// flat lids, have less than a twentieth of its area. Any other open part keeps its winding if that was consistent; the
/// sign of the volume, as seen from the middle of its box, means little there and is only reported (`doubtful`). If the
/// winding was not consistent, the sign of the volume decides, or, if there is almost no volume (a plane), the winding
/// of most of the area. Finally, the parts in `flipped`, numbered from 1, are turned inside out. The scale of the
/// positions is about 1.
Orientation orient(Soup& soup, const std::vector<std::uint32_t>& flipped = {});

}  // namespace pelage
