// The places of a model's vertices in its texture, each with the tangent space of the texture there.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// A vertex as one island of the texture has it. Its tangent space is dP/du, the mean over the island's triangles
/// around it by their areas, made orthogonal to the vertex's normal N, as x, and N x dP/du as y; on a mirrored island y
/// is turned over, so that it points along +v there too. Where plain and mirrored triangles share a place, as in the
/// fold of an island, the side with more area counts.
struct UvCorner {
  std::uint32_t vertex = 0;
  glm::vec2 uv{0};        // v up
  glm::dvec2 axis{1, 0};  // x in the vertex's (tangent, bitangent); unit
  double side = 1;        // -1 on mirrored islands
  bool mapped = false;    // false where no triangle around it has an area in the texture

  /// A vector in the vertex's (tangent, bitangent) as parts along +u and +v, and back.
  glm::dvec2 to_uv(glm::dvec2 d) const { return {axis.x * d.x + axis.y * d.y, side * (axis.x * d.y - axis.y * d.x)}; }
  glm::dvec2 from_uv(glm::dvec2 d) const {
    return {axis.x * d.x - side * axis.y * d.y, axis.y * d.x + side * axis.x * d.y};
  }
};

struct UvCorners {
  std::vector<UvCorner> corners;        // by rising vertex; a vertex on a seam has several
  std::vector<glm::uvec3> of_triangle;  // for each triangle of the mesh its corners' numbers
  std::vector<std::uint32_t> first;     // for each vertex its first corner, and the count at the end

  std::span<const UvCorner> of_vertex(std::uint32_t vertex) const {
    return std::span(corners).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// Those of a UDIM tile, by the middles of their triangles, moved to [0, 1]; all as they are where `tile` is 0.
UvCorners in_udim(UvCorners uvs, int tile);

/// The tiles that triangles lie in, by their middles, rising. Those that have no number are left out.
std::vector<int> udims_of(const UvCorners& uvs);

/// Corners of triangles with the same vertex and the same coordinates are one. The mesh has texture
/// coordinates.
UvCorners make_uv_corners(const Mesh& mesh);

}  // namespace pelage
