// Polygons of an implicit surface: closed, even, with about as many triangles as wished for.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/builtin/implicit.h"

namespace pelage {

/// Triangles are wound counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;
};

/// Marching tetrahedra on a grid of cubes `cell` wide (> 0). Always a closed 2-manifold; its triangles are uneven and
/// its vertices lie within a cell of the surface. Features thinner than two cells may break.
TriangleMesh polygonise(const ImplicitSurface& surface, double cell);

/// The part of a closed mesh with the most triangles.
TriangleMesh largest_part(const TriangleMesh& mesh);

/// Makes the edges of a closed mesh near `surface` as even as can be, with about `triangles` of them (a few hundred
/// or more), and lays the vertices on the surface. Keeps the mesh a closed 2-manifold of the same genus. Deterministic.
TriangleMesh remesh(const ImplicitSurface& surface, const TriangleMesh& mesh, int triangles);

/// Merges edges of a closed mesh until `triangles` are left, those first that change the shape least (quadric error).
/// Keeps thin features longer than remesh, and edges less even. May stop early rather than fold. Deterministic.
TriangleMesh decimate(const TriangleMesh& mesh, int triangles);

}  // namespace pelage
