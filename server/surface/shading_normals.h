// Shading normals, split at creases, and growth directions of fur at creases and open edges.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// Returns a unit normal for each corner of each triangle. It is that of the vertex (`normals`), unless a crease (an
/// edge sharper than `crease_degrees`) ends at the vertex; then it is the area-weighted normal of the triangles that
/// are connected around the vertex without crossing a crease. The sharpness is the angle between the normals of an
/// edge's two triangles; an edge of more triangles is sharp, an open one is not. Empty if there are no creases. The
/// scale of `positions` is about 1, and triangles are wound consistently. `crease_degrees` is in [0, 180]; 180 for no
/// creases.
std::vector<std::array<glm::vec3, 3>> shading_normals(std::span<const glm::dvec3> positions,
                                                      const std::vector<glm::uvec3>& triangles,
                                                      std::span<const glm::vec3> normals, double crease_degrees);

/// Makes fur grow out of creases: at each vertex with split shading normals (see above), `normals` becomes their mean,
/// in which each counts once, however large its triangles are. If they cancel it stays. Returns the vertices that
/// changed.
std::vector<std::uint32_t> grow_over_creases(const std::vector<glm::uvec3>& triangles,
                                             const std::vector<std::array<glm::vec3, 3>>& shading_normals,
                                             std::vector<glm::vec3>& normals);

/// Makes fur at open edges lean over the rim, so that its roots, which hardly any light reaches, are not visible from
/// the side. The open edges at a vertex together count as one more side, whose normal points out over the rim, and fur
/// grows along the mean of the vertex's sides. The shading of the skin stays: a mesh with a rim gets shading normals
/// for that.
void lean_over_rims(Mesh& mesh);

}  // namespace pelage
