// Subdivides triangles of a mesh, together with their map to the sample tile.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/status.h"
#include "server/patches/patches.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A triangle that is all or a part of its parent. Corners 0 to 2 are those of the parent, 3 to 5 the middles of its
/// sides.
struct ChildTriangle {
  std::uint32_t parent = 0;
  std::array<std::uint8_t, 3> corners{0, 1, 2};
};

/// Returns the map on the children of its triangles, which must be in the order of their parents. `subdivided` is their
/// mesh.
PatchMap subdivide_patches(const PatchMap& map, const std::vector<ChildTriangle>& children, const Mesh& subdivided);

// Splitting triangles of the field mesh at the middles of their edges; the shape stays (linear subdivision).

/// Half-open range of triangles.
struct TriangleRun {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const TriangleRun&) const = default;
};
/// The triangles that one subdivision splits: rising runs that do not touch; none is empty.
using ChosenTriangles = std::vector<TriangleRun>;

/// A mesh after one subdivision. Old vertices keep their numbers; parents[k] are the two ends of the edge that vertex
/// (old count + k) halves.
struct SubdividedSurface {
  Mesh mesh;
  PatchMap patches;
  std::vector<glm::uvec2> parents;
};

/// Splits every chosen triangle in four and those that share an edge with one in two, three or four, so that no cracks
/// and no vertices within edges appear. New vertices lie in the middle, rounded to 32 bits; an edge without a 32-bit
/// point between its ends is not split. Normals and tangents are their parents' means, made unit and orthogonal again;
/// colours, texture coordinates and positions on the sample tile are means, so that no root of fur moves. Patch
/// triangles with a weight of 0 on a new triangle are left out. Refused (invalid): a choice beyond the mesh, or more
/// triangles than the limit of models. Deterministic at any thread count.
Result<SubdividedSurface> subdivide(const Mesh& mesh, const PatchMap& patches, const ChosenTriangles& chosen);

}  // namespace pelage
