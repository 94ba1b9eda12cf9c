// Triangulation of polygons, and consistent orientation of the resulting parts.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/weld.h"

namespace pelage {

/// Triangles of a polygon as indices of its corners, wound as the polygon. Corners that follow each other on the same
/// vertex count once. Convex polygons become a fan, quads split at the shorter diagonal that lies inside, others lose
/// ears; non-convex polygons of more than 128 corners become a fan too, so that no file costs cubic time. Triangles
/// without area are left out. `positions` are about the size of 1.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const std::uint32_t> vertices,
                                                      const std::vector<glm::dvec3>& positions);

/// Returns whether the height of the triangle is below rounding.
bool has_no_area(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

// Winding that agrees within each part and faces outwards.

/// Triangles that hang together by edges of two.
struct WoundPart {
  std::uint32_t first = 0;  // its first triangle
  std::size_t triangles = 0;
  Placement box;
  bool doubtful = false;  // ModelReport::doubtful_parts
  bool sheet = false;     // open, and encloses next to nothing
};

struct Orientation {
  std::size_t flipped_triangles = 0;
  std::size_t open_edges = 0;          // of one triangle
  std::size_t non_manifold_edges = 0;  // of three triangles or more
  std::size_t one_sided_edges = 0;     // across which the winding cannot agree, as on a Moebius strip
  std::vector<WoundPart> parts;        // in the order of their first triangles
  std::vector<std::uint32_t> part_of;  // of each triangle, its place in `parts`
};

/// Turns triangles so that neighbours across each edge of two triangles agree. A part without open edges then encloses
/// a positive signed volume, and so does one that is nearly closed: whose holes, as flat as they can be, have less than
/// a twentieth of its area, as a scan has. Any other open part keeps its winding where that agreed: the sign of what it
/// encloses, as seen from the middle of its box, means little and is only reported (`doubtful`). Where it did not
/// agree, that sign decides, or where it encloses next to nothing (a plane) the winding that most of its area had.
/// Parts in `flipped`, by their numbers from 1, are turned around in the end. Positions are about the size of 1.
Orientation orient(Soup& soup, const std::vector<std::uint32_t>& flipped = {});

}  // namespace pelage
