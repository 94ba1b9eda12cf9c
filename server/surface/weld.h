// Welding polygons on equal positions, and the triangles, parts and placement that preparation works on.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/status.h"
#include "server/surface/mesh.h"

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

// The good faces of a file with welded vertices.

/// Why a face is not valid.
enum class BadFace { none, corners, vertices, numbers };  // fewer than three; not all in the file; not all finite

/// The valid faces: three corners or more, all of them finite vertices of the file.
struct Polygons {
  struct Face {
    std::uint32_t source;  // in RawModel::face_sizes
    std::uint32_t begin;   // in RawModel::corners
    std::uint32_t size;
  };
  std::vector<Face> faces;
  std::vector<glm::dvec3> positions;       // welded, used ones only, turned; in order of first use
  std::vector<std::uint32_t> sources;      // of each position: the first of the file
  std::vector<std::uint32_t> vertex;       // of each position of the file: its welded one, no_position when unused
  std::array<std::size_t, 4> bad_faces{};  // by BadFace
  std::size_t bad(BadFace why) const { return bad_faces[static_cast<std::size_t>(why)]; }
  std::size_t used = 0;  // positions of the file that are used
};

/// Welds vertices on equal positions (bit for bit; -0 equals 0) after `turn`. Refuses (invalid) coordinates over the
/// limit.
Result<Polygons> weld(const RawModel& raw, const glm::dmat3& turn);

// What the corners of triangles look like.

/// Looks of all corners, from the materials, vertex colours and texture coordinates of the file; empty when the model
/// has no colours of its own: no picture, and one grey all over, which is what programs write when nobody chose one.
/// Colours that are not finite or negative count as white.
std::vector<std::array<LookCorner, 3>> look_corners(const RawModel& raw, const Soup& soup);

/// How many triangles have texture coordinates in the file that are no place in a picture: infinite, or beyond a
/// million. Look and texture corners leave them out.
std::size_t count_unusable_uvs(const RawModel& raw, const Soup& soup);

/// The file's texture coordinates of all corners, whether or not it has a picture; empty when it has none.
std::vector<std::array<glm::vec2, 3>> texture_corners(const RawModel& raw, const Soup& soup);

}  // namespace pelage
