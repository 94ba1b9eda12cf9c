// Where the sample tile lies on the surface: lapped patches (GPU fur 1; Praun et al. 2000). Laid once, when the model
// is prepared; combing turns the strands, not the map, so roots never move.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/status.h"
#include "server/patches/flatten.h"
#include "server/patches/patch_cells.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A vertex as one patch has it.
struct PatchPoint {
  std::uint32_t vertex = 0;
  std::uint32_t patch = 0;
  glm::vec2 uv{0};    // place on the sample tile, sizes
  glm::vec3 axis{0};  // direction in which u grows there: unit, orthogonal to the vertex's normal
  float weight = 0;   // [0, 1]: share of the fur's optical depth
};

/// A triangle as one patch has it.
struct Piece {
  std::uint32_t triangle = 0;
  std::uint32_t patch = 0;
  glm::uvec3 points{0};  // of the triangle's corners in order, in PatchMap::points
};

/// Every triangle has a piece, and the weights that a vertex has in the pieces' patches sum to 1; so do their linear
/// interpolations in a triangle over its pieces. No strand is missing and none counts twice.
struct PatchMap {
  std::vector<PatchPoint> points;  // by patch, then vertex
  std::vector<Piece> pieces;       // by triangle, then patch
  std::uint32_t patches = 0;
};

/// Covers any prepared mesh with patches that overlap softly: cells of limited bending, a ragged overlap as wide as
/// the triangles and 1.25 times the area allow, each flattened with little stretch and its u axis along the mesh's
/// tangents, each at a random place of the tile. Cells that stretch too much are split. The same bits at any thread
/// count.
PatchMap lay_patches(const Mesh& mesh);

/// The same map with hard borders: each triangle keeps the piece with the largest mean weight, at weight 1.
PatchMap hard_pieces(const PatchMap& map);

/// Returns whether the model has texture coordinates that span an area.
bool has_own_uvs(const Mesh& mesh);

/// The map that the model's own texture coordinates make: a patch for each of their islands, at the scale that keeps
/// the island's area; mirrored islands are turned over. One piece for each triangle, weight 1. Refused (invalid) when
/// the model has no texture coordinates that span an area.
Result<PatchMap> own_uv_patches(const Mesh& mesh);

/// How the map stretches a piece.
Stretch stretch_of(const Mesh& mesh, const PatchMap& map, const Piece& piece);

// From a flattened patch to the points of a map.

/// Points of all vertices of `flat`, in their order, at weight 0. The axis is the mean of its triangles' around a
/// vertex; where there is none, the vertex's tangent.
std::vector<PatchPoint> make_points(const Mesh& mesh, const FlatPatch& flat, std::uint32_t patch);

// How much each patch counts at each vertex: soft overlaps whose weights sum to 1 everywhere.

/// What one patch has of a vertex, (0, 1].
struct PatchShare {
  std::uint32_t patch = 0;
  float weight = 0;
};

/// Shares of each vertex, by rising patch; their sum is 1.
struct VertexShares {
  std::vector<std::uint32_t> begin;  // vertices + 1
  std::vector<PatchShare> shares;

  std::span<const PatchShare> of(std::uint32_t vertex) const {
    return std::span(shares).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// How far patches extend over the borders of their cells.
struct Overlap {
  double width = 0.03;        // at most, sizes; noise makes it irregular
  double area_factor = 1.25;  // of all pieces over the surface, at most, where one ring of triangles allows it
};

/// A patch counts fully in its own cell, less with the distance from it, and nothing beyond the width; shares are these
/// normalised. The width is the largest that keeps the area factor. Within it lies always the ring of triangles that
/// touch the cell. Deterministic.
VertexShares share_vertices(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, const Overlap& overlap);

/// The patches of a triangle: those with a share at a corner, rising, each once.
void patches_at(const VertexShares& shares, const glm::uvec3& triangle, std::vector<std::uint32_t>& patches);

}  // namespace pelage
