// Normals that a surface is seen by, split where it has an edge.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// Returns a unit normal for each corner of each triangle: that of its vertex (`normals`), unless an edge that is
/// sharper than `crease_degrees` ends at the vertex. Then it is the area-weighted one of the triangles that are reached
/// around the vertex without crossing such an edge. Sharpness is the angle between the normals of an edge's two
/// triangles; an edge of more triangles is sharp, an open one is not. Empty where no edge is sharp. `positions` are
/// about the size of 1, triangles are wound alike; [0, 180] degrees, 180 for none.
std::vector<std::array<glm::vec3, 3>> shading_normals(std::span<const glm::dvec3> positions,
                                                      const std::vector<glm::uvec3>& triangles,
                                                      std::span<const glm::vec3> normals, double crease_degrees);

/// Makes fur grow out of creases: at each vertex that has shading normals of its own (as above), `normals` becomes the
/// mean of them, each counted once, however large its triangles are; where they cancel it stays. Returns the vertices
/// that changed.
std::vector<std::uint32_t> grow_over_creases(const std::vector<glm::uvec3>& triangles,
                                             const std::vector<std::array<glm::vec3, 3>>& shading_normals,
                                             std::vector<glm::vec3>& normals);

/// Makes fur at open edges lean over the rim, so that its roots, which hardly any light reaches, are not seen from the
/// side. Each open edge counts as a side that faces away from its triangle, and a vertex grows fur along the mean of
/// its sides. The skin is lit as before: a mesh with a rim has shading normals afterwards.
void lean_over_rims(Mesh& mesh);

}  // namespace pelage
