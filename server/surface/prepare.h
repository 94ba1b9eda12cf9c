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

/// Returns area-weighted vertex normals; where they cancel, that of the vertex's first triangle. Tangents point towards
/// the tail: the projection of -Z into the tangent plane, or of -Y where that vanishes. Every vertex must belong to a
/// triangle with an area.
Frames make_frames(const Soup& soup);

/// Returns the rotation that takes `up` to +Y and `front` to +Z; they must lie on different lines.
glm::dmat3 axes_rotation(Axis up, Axis front);
/// Returns the axis that a rotation takes to `to`. The rotation must map axes to axes.
Axis axis_mapped_to(const glm::dmat3& rotation, Axis to);

/// Returns the unit tangent that points towards the tail, for a unit normal.
glm::dvec3 tailward(glm::dvec3 normal);

// Preparation of polygons to a mesh that can be groomed.

/// Options of the preparation.
struct PrepareOptions {
  Axis up = Axis::plus_y, front = Axis::plus_z;  // on different lines
  bool source_is_32_bit = false;                 // RawModel::is_32_bit
  double crease_degrees = default_crease_degrees;
  // Numbers of parts, from 1.
  std::vector<std::uint32_t> flipped_parts = {};    // parts to turn inside out
  std::vector<std::uint32_t> two_sided_parts = {};  // parts that get a back side (add_backs)
};

/// Prepares a mesh, in this order. Drops invalid faces (fewer than 3 corners, repeated or out-of-range vertices,
/// non-finite coordinates or zero area in double). Triangulates polygons, rotates `up` to +Y and `front` to +Z, welds
/// vertices of equal position, drops repeated faces and unused vertices. Makes the winding of each part consistent
/// (orient), turns the requested parts inside out and adds back sides to others. Centres and scales in double. Computes
/// area-weighted vertex normals (zero sums take any triangle's; at creases all sides count equally), shading normals,
/// and tangents that point towards the tail (the projection of -Z; of -Y where that vanishes). Positions are rounded to
/// 32 bits last.
/// Refuses (invalid): no triangle left, coordinates over 1e20, more triangles than the limit, zero size, or 32-bit
/// steps above 1e-4 of the size ("precision": |coordinate| * 2^-23 > 1e-4 size) if `source_is_32_bit`; also `up` and
/// `front` on one line ("/front"), and a part that does not exist ("/flip", "/two_sided"). Deterministic.
/// The report lists every repair made here and every loss of the file's parser. It counts what cannot be repaired:
/// open, non-manifold and one-sided edges, parts and vertices far from the rest, and parts too small to see.
Result<Mesh> prepare(const RawModel& raw, const PrepareOptions& options = {});

/// A prepared mesh, with the origin of its vertices.
struct PreparedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> sources;  // for each vertex: index in RawModel::positions of the first one welded into it
  glm::dmat3 rotation{1};              // rotation from the file's axes to +Y up and +Z forward

  /// Converts a position of the file to internal coordinates.
  glm::dvec3 to_internal(glm::dvec3 raw) const { return mesh.to_internal(rotation * raw); }
};
Result<PreparedMesh> prepare_with_sources(const RawModel& raw, const PrepareOptions& options = {});

}  // namespace pelage
