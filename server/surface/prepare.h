// Normals and tangents of vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/base/status.h"
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

/// The unit tangent of a surface with this unit normal that points tailwards.
glm::dvec3 tailward(glm::dvec3 normal);

// From polygons to a mesh that can be groomed.

/// Drops faces that are no faces (fewer than 3 corners, repeated or out-of-range vertices, non-finite or zero area in
/// double), triangulates n-gons, turns `up` to +Y and `front` to +Z, welds vertices on equal positions, drops repeated
/// faces and unused vertices, makes the winding of each part agree and point outwards (signed volume), centres and
/// scales in double, and makes area-weighted vertex normals (zero sums get any triangle's) and tangent frames whose
/// tangent points tailwards (the surface part of -Z; of -Y where that vanishes). Positions are rounded to 32 bits last.
/// Refused (invalid): no triangle left, coordinates over 1e20, more triangles than the limit, zero size, or 32-bit
/// steps above 1e-4 of the size ("precision": |coordinate| * 2^-23 > 1e-4 size) when `source_is_32_bit`.
/// `up` and `front` lie on different axes, else refused. Callers pass RawModel::is_32_bit as `source_is_32_bit`.
/// Deterministic. The report lists every repair that happened, and counts what cannot be repaired: open, non-manifold
/// and one-sided edges.
Result<Mesh> prepare(const RawModel& raw, Axis up, Axis front, bool source_is_32_bit);

}  // namespace pelage
