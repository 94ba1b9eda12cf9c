// Normals that a surface is seen by, split where it has an edge.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// For each corner of each triangle a unit normal: that of its vertex (`normals`), but where an edge that is sharper
/// than `crease_degrees` ends at the vertex. There it is the area-weighted one of the triangles that are reached around
/// the vertex without crossing such an edge. Sharpness is the angle between the normals of an edge's two triangles;
/// edges of other counts are sharp beside one. Empty where no edge is. `positions` are about the size of 1, triangles
/// are wound alike; [0, 180] degrees, 180 for none.
std::vector<std::array<glm::vec3, 3>> shading_normals(std::span<const glm::dvec3> positions,
                                                      const std::vector<glm::uvec3>& triangles,
                                                      std::span<const glm::vec3> normals, double crease_degrees);

/// Where fur grows at creases: at each vertex that has shading normals of its own (as above), `normals` becomes the
/// mean of them, each counted once, however large its triangles are; where they cancel it stays. The vertices that
/// changed.
std::vector<std::uint32_t> grow_over_creases(const std::vector<glm::uvec3>& triangles,
                                             const std::vector<std::array<glm::vec3, 3>>& shading_normals,
                                             std::vector<glm::vec3>& normals);

/// At open edges fur leans over the rim, so that its roots are not seen from the side, where hardly any light comes:
/// each counts as the side of a sheet that looks away from its triangle, and a vertex grows fur along the mean of its
/// sides. The skin is lit as before: the mesh has shading normals afterwards where it has a rim.
void lean_over_rims(Mesh& mesh);

}  // namespace pelage
