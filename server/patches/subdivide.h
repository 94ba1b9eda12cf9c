// Places on the sample tile after triangles were split.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/status.h"
#include "server/patches/patches.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A triangle that came of another one: its corners, 0 to 2 those of the other, 3 to 5 the middles of its sides.
struct ChildTriangle {
  std::uint32_t parent = 0;
  std::array<std::uint8_t, 3> corners{0, 1, 2};
};

/// The map on the children of its triangles; they lie in the order of their parents. `subdivided` is their mesh.
PatchMap subdivide_patches(const PatchMap& map, const std::vector<ChildTriangle>& children, const Mesh& subdivided);

// Splitting triangles of the field mesh at the middles of their edges; the shape stays (linear subdivision).

/// Half-open range of triangles.
struct TriangleRun {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const TriangleRun&) const = default;
};
/// What one subdivision splits: runs that rise and do not touch; none is empty.
using ChosenTriangles = std::vector<TriangleRun>;

/// A mesh after one subdivision. Vertices that were there keep their numbers; parents[k] are the two ends of the edge
/// that vertex (old count + k) halves.
struct SubdividedSurface {
  Mesh mesh;
  PatchMap patches;
  std::vector<glm::uvec2> parents;
};

/// Splits every chosen triangle in four and those that share an edge with one in two, three or four, so that no crack
/// and no vertex within an edge appears. New vertices lie in the middle, rounded to 32 bits; an edge without a 32-bit
/// point between its ends stays whole. Normals and tangents are their parents' means, made unit and orthogonal again;
/// colours, texture coordinates and places on the sample tile are means, so that no root of fur moves. Pieces of
/// patches that count nothing on a new triangle are left out. Refused (invalid): a choice beyond the mesh, or more
/// triangles than the limit of models. The same bits at any thread count.
Result<SubdividedSurface> subdivide(const Mesh& mesh, const PatchMap& patches, const ChosenTriangles& chosen);

}  // namespace pelage
