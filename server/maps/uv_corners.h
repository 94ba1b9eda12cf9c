// The positions of a model's vertices in its texture, each with the tangent space of the texture there.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// A vertex in one island of the texture. The x axis of its tangent space is dP/du, the mean over the island's
/// triangles around it by their areas, made orthogonal to the vertex's normal N; the y axis is N x dP/du, negated on a
/// mirrored island, so that it always points along +v. Where plain and mirrored triangles share a position, as in the
/// fold of an island, the side with more area counts.
struct UvCorner {
  std::uint32_t vertex = 0;
  glm::vec2 uv{0};        // v up
  glm::dvec2 axis{1, 0};  // x in the vertex's (tangent, bitangent); unit
  double side = 1;        // -1 on mirrored islands
  bool mapped = false;    // false if no triangle around it has an area in the texture

  /// Converts a vector in the vertex's (tangent, bitangent) to components along +u and +v, and back.
  glm::dvec2 to_uv(glm::dvec2 d) const { return {axis.x * d.x + axis.y * d.y, side * (axis.x * d.y - axis.y * d.x)}; }
  glm::dvec2 from_uv(glm::dvec2 d) const {
    return {axis.x * d.x - side * axis.y * d.y, axis.y * d.x + side * axis.x * d.y};
  }
};

struct UvCorners {
  std::vector<UvCorner> corners;        // by rising vertex; a vertex on a seam has several
  std::vector<glm::uvec3> of_triangle;  // for each triangle of the mesh: indices of its corners
  std::vector<std::uint32_t> first;     // for each vertex: index of its first corner; the count at the end

  std::span<const UvCorner> of_vertex(std::uint32_t vertex) const {
    return std::span(corners).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// Returns the corners of triangles whose centres are in a UDIM tile, moved to [0, 1]; all, unchanged, if `tile` is 0.
UvCorners in_udim(UvCorners uvs, int tile);

/// Returns the UDIM tiles of the centres of triangles, rising. Squares without a UDIM number are left out.
std::vector<int> udims_of(const UvCorners& uvs);

/// Makes the corners of a mesh, which must have texture coordinates. Corners of triangles with the same vertex and the
/// same coordinates are merged.
UvCorners make_uv_corners(const Mesh& mesh);

}  // namespace pelage
