// How a surface turns as it moves, so that what stands on it goes along.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// The rotation at each vertex that takes the surface from `rest` to where its vertices are at `positions`: the normal
/// to the normal, and about it the rotation nearest to how the triangles around the vertex are stretched (the polar
/// factor in the plane of the skin, as in Sorkine and Alexa 2007, in closed form). Rotations for all finite positions.
std::vector<glm::dmat3> surface_turns(const Mesh& rest, std::span<const glm::vec3> positions);

/// Returns the mesh with its vertices moved. Normals, shading normals and tangents turn with the surface, so that
/// creases stay where they are and a direction field goes along; triangles, looks, centre and size are those at rest.
Mesh moved(Mesh rest, std::vector<glm::vec3> positions, std::span<const glm::dmat3> turns);

}  // namespace pelage
