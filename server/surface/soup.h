// Triangles while they are prepared.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// Triangles with welded vertices, each with the corners of the file that it came from.
struct Soup {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> sources;  // of each position: the first one of the file that was welded into it
  std::vector<glm::uvec3> triangles;   // positions
  std::vector<glm::uvec3> corners;     // of each triangle: indices in RawModel::corners
  std::vector<std::uint32_t> faces;    // of each triangle: its face in the file

  void add(glm::uvec3 vertices, glm::uvec3 source_corners, std::uint32_t face) {
    triangles.push_back(vertices);
    corners.push_back(source_corners);
    faces.push_back(face);
  }
};

/// Keeps the first of all triangles on the same three vertices, whichever way they are wound. Gives the number dropped.
std::size_t drop_repeated(Soup& soup);

/// Drops vertices that no triangle uses and keeps the order of the others.
void drop_unused(Soup& soup);

/// Parts that hang together by vertices; all vertices are used.
std::size_t count_parts(const Soup& soup);

/// Where a model lies: the centre and the diagonal of its box.
struct Placement {
  glm::dvec3 low{0}, high{0};
  glm::dvec3 centre{0};
  double size = 0;

  glm::dvec3 to_internal(glm::dvec3 p) const { return (p - centre) / size; }
};

/// The box of all positions; there is at least one. Coordinates up to 1e20 do not overflow.
Placement place(const std::vector<glm::dvec3>& positions);

}  // namespace pelage
