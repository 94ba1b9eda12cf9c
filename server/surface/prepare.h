// Preparation of a raw model: repair, weld, orient and scale it, and make the normals and tangents of its vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/status.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"
#include "server/surface/weld.h"

namespace pelage {

struct Frames {
  std::vector<glm::vec3> normals;   // unit
  std::vector<glm::vec3> tangents;  // unit, orthogonal to the normals
};

/// Area-weighted normals; where they cancel, that of the vertex's first triangle. Tangents point tailwards: the
/// surface part of -Z, of -Y where that vanishes. Every vertex belongs to a triangle with an area.
Frames make_frames(const Soup& soup);

/// The rotation that turns `up` to +Y and `front` to +Z; they lie on different lines.
glm::dmat3 turn_of(Axis up, Axis front);
/// The axis that a rotation of axes onto axes takes to `to`.
Axis axis_turned_to(const glm::dmat3& turn, Axis to);

/// The unit tangent of a surface with this unit normal that points tailwards.
glm::dvec3 tailward(glm::dvec3 normal);

// From polygons to a mesh that can be groomed.

/// How a model is prepared.
struct PrepareOptions {
  Axis up = Axis::plus_y, front = Axis::plus_z;  // on different lines
  bool source_is_32_bit = false;                 // RawModel::is_32_bit
  double crease_degrees = default_crease_degrees;
  // Numbers of parts, from 1, that
  std::vector<std::uint32_t> flipped_parts = {};    // turn inside out
  std::vector<std::uint32_t> two_sided_parts = {};  // get a back (add_backs)
};

/// Drops faces that are no faces (fewer than 3 corners, repeated or out-of-range vertices, non-finite or zero area in
/// double), triangulates n-gons, turns `up` to +Y and `front` to +Z, welds vertices on equal positions, drops repeated
/// faces and unused vertices, makes the winding of each part agree (orient), turns the parts that are asked for and
/// gives backs to others, centres and scales in double, and makes area-weighted vertex normals (zero sums get any
/// triangle's; at creases all sides count alike), shading normals, and tangent frames whose tangent points tailwards
/// (the surface part of -Z; of -Y where that vanishes). Positions are rounded to 32 bits last. Refused (invalid): no
/// triangle left, coordinates over 1e20, more triangles than the limit, zero size, or 32-bit steps above 1e-4 of the
/// size ("precision": |coordinate| * 2^-23 > 1e-4 size) when `source_is_32_bit`. Also refused: `up` and `front` on one
/// line ("/front"), and a part that is not there ("/flip", "/two_sided"). Deterministic. The report lists every repair
/// that happened, what the file lost before, and counts what cannot be repaired: open, non-manifold and one-sided
/// edges, parts and vertices far from the rest, and parts too small to see.
Result<Mesh> prepare(const RawModel& raw, const PrepareOptions& options = {});

/// A prepared mesh, and where its vertices came from.
struct PreparedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> sources;  // in RawModel::positions, of each vertex: the first that was welded into it
  glm::dmat3 turn{1};                  // from the file's axes to +Y up and +Z in front

  /// Where a position of the file lies.
  glm::dvec3 to_internal(glm::dvec3 raw) const { return mesh.to_internal(turn * raw); }
};
Result<PreparedMesh> prepare_with_sources(const RawModel& raw, const PrepareOptions& options = {});

}  // namespace pelage
