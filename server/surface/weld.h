// Welds polygons at equal positions; defines the triangles, parts and placement that preparation works on.
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
  std::vector<std::uint32_t> sources;  // for each position: the first position of the file that was welded into it
  std::vector<glm::uvec3> triangles;   // indices of positions
  std::vector<glm::uvec3> corners;     // for each triangle: indices in RawModel::corners
  std::vector<std::uint32_t> faces;    // for each triangle: its face in the file

  void add(glm::uvec3 vertices, glm::uvec3 source_corners, std::uint32_t face) {
    triangles.push_back(vertices);
    corners.push_back(source_corners);
    faces.push_back(face);
  }
};

/// Drops all but the first of triangles with the same three vertices, whatever their winding. Returns the number
/// dropped.
std::size_t drop_repeated(Soup& soup);

/// Drops vertices that no triangle uses; the others keep their order.
void drop_unused(Soup& soup);

/// Returns the number of parts connected by vertices. All vertices must be used.
std::size_t count_parts(const Soup& soup);

/// The bounding box of a model, with its centre and diagonal.
struct Placement {
  glm::dvec3 low{0}, high{0};
  glm::dvec3 centre{0};
  double size = 0;

  glm::dvec3 to_internal(glm::dvec3 p) const { return (p - centre) / size; }
};

/// Returns the bounding box of at least one position. Coordinates up to 1e20 do not overflow.
Placement placement_of(const std::vector<glm::dvec3>& positions);

// The valid faces of a file with welded vertices.

/// Why a face is not valid.
enum class BadFace { none, corners, vertices, numbers };  // fewer than 3; not in the file; not finite

/// The valid faces: those with three or more corners, all of them finite vertices of the file.
struct Polygons {
  struct Face {
    std::uint32_t source;  // index in RawModel::face_sizes
    std::uint32_t begin;   // first index in RawModel::corners
    std::uint32_t size;
  };
  std::vector<Face> faces;
  std::vector<glm::dvec3> positions;       // welded and rotated; only used ones, in order of first use
  std::vector<std::uint32_t> sources;      // for each position: the first position of the file
  std::vector<std::uint32_t> vertex;       // for each position of the file: its welded one; no_position if unused
  std::array<std::size_t, 4> bad_faces{};  // counts, indexed by BadFace
  std::size_t bad(BadFace why) const { return bad_faces[static_cast<std::size_t>(why)]; }
  std::size_t used = 0;  // number of positions of the file that are used
};

/// Welds vertices of equal position (bit for bit; -0 equals 0) after `rotation`. Refuses (invalid) coordinates
/// over the limit.
Result<Polygons> weld(const RawModel& raw, const glm::dmat3& rotation);

// The appearance of triangle corners.

/// Returns the appearance of all corners, from the materials, vertex colours and texture coordinates of the file. Empty
/// if the model has no colours of its own: no picture, and a single grey, which is what programs write by default.
/// Colours that are negative or not finite count as white.
std::vector<std::array<LookCorner, 3>> look_corners(const RawModel& raw, const Soup& soup);

/// Returns the number of triangles with unusable texture coordinates: infinite, or beyond a million. look_corners and
/// texture_corners leave them out.
std::size_t count_unusable_uvs(const RawModel& raw, const Soup& soup);

/// Returns the file's texture coordinates of all corners, even if it has no picture; empty if it has none.
std::vector<std::array<glm::vec2, 3>> texture_corners(const RawModel& raw, const Soup& soup);

}  // namespace pelage
