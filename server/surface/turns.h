// Rotations of a surface that moves, for the things that stand on it.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// Returns for each vertex the rotation that takes the surface from `rest` to the given positions. It takes the normal
/// to the new normal; about the normal it is the rotation nearest to the deformation of the triangles around the vertex
/// (the polar factor in the tangent plane, as in Sorkine and Alexa 2007, in closed form). Valid rotations for all
/// finite positions.
std::vector<glm::dmat3> surface_rotations(const Mesh& rest, std::span<const glm::vec3> positions);

/// Returns the mesh with its vertices moved. Normals, shading normals and tangents rotate with the surface, so that
/// creases stay and a direction field moves along. Triangles, colours, centre and size are those at rest.
Mesh moved(Mesh rest, std::vector<glm::vec3> positions, std::span<const glm::dmat3> rotations);

}  // namespace pelage
