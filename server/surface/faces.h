// Polygons to triangles.
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

/// Whether the height of the triangle is below rounding.
bool has_no_area(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

// Winding that agrees within each part and faces outwards.

struct Orientation {
  std::size_t flipped_triangles = 0;
  std::size_t open_edges = 0;          // of one triangle
  std::size_t non_manifold_edges = 0;  // of three triangles or more
  std::size_t one_sided_edges = 0;     // across which the winding cannot agree, as on a Moebius strip
};

/// Turns triangles so that neighbours across each edge of two triangles agree, and each such part encloses a positive
/// signed volume around the middle of its box. A part that encloses next to nothing (a plane) keeps the winding that
/// most of its area had. Deterministic.
Orientation orient(Soup& soup);

}  // namespace pelage
