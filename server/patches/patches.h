// Maps the surface to the sample tile by lapped patches (GPU fur 1; Praun et al. 2000). The map is made once, when the
// model is prepared; combing turns the strands, not the map, so roots never move.
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

/// A vertex in one patch.
struct PatchPoint {
  std::uint32_t vertex = 0;
  std::uint32_t patch = 0;
  glm::vec2 uv{0};    // position on the sample tile, sizes
  glm::vec3 axis{0};  // direction in which u grows there: unit, orthogonal to the vertex's normal
  float weight = 0;   // [0, 1]: share of the fur's optical depth
};

/// A triangle in one patch.
struct PatchTriangle {
  std::uint32_t triangle = 0;
  std::uint32_t patch = 0;
  glm::uvec3 points{0};  // indices in PatchMap::points of the triangle's corners, in order
};

/// Every triangle has at least one patch triangle. The weights of a vertex over its patches sum to 1, and so do their
/// linear interpolations in a triangle over its patch triangles: no strand is missing and none counts twice.
struct PatchMap {
  std::vector<PatchPoint> points;              // by patch, then vertex
  std::vector<PatchTriangle> patch_triangles;  // by triangle, then patch
  std::uint32_t patches = 0;
};

/// Covers any prepared mesh with patches that overlap softly: cells of limited bending with a ragged overlap (Overlap),
/// at least a ring of triangles wide. Each patch is flattened with little stretch, has its u
/// axis along the mesh's tangents and is at a random position of the tile. Cells that stretch too much are split.
/// Deterministic at any thread count.
PatchMap lay_patches(const Mesh& mesh);

/// Returns the map with hard borders: each triangle keeps the patch triangle with the largest mean weight, at weight 1.
PatchMap with_hard_borders(const PatchMap& map);

/// Returns whether the model has texture coordinates that span an area.
bool has_own_uvs(const Mesh& mesh);

/// Returns the map of the model's own texture coordinates: a patch for each of their islands, at the scale that
/// preserves the island's area; mirrored islands are flipped. Each triangle has one patch triangle of weight 1. Refused
/// (invalid) if the model has no texture coordinates that span an area.
Result<PatchMap> own_uv_patches(const Mesh& mesh);

/// Returns how the map stretches a patch triangle.
Stretch stretch_of(const Mesh& mesh, const PatchMap& map, const PatchTriangle& patch_triangle);

// Converts a flattened patch to the points of a map.

/// Returns points for all vertices of `flat`, in their order, with weight 0. A point's axis is the mean of the axes of
/// the triangles around it or, if that vanishes, the vertex's tangent.
std::vector<PatchPoint> make_points(const Mesh& mesh, const FlatPatch& flat, std::uint32_t patch);

// The weights of patches at vertices: soft overlaps whose weights sum to 1 everywhere.

/// The weight of one patch at a vertex, (0, 1].
struct PatchShare {
  std::uint32_t patch = 0;
  float weight = 0;
};

/// The shares of each vertex, by rising patch; their sum is 1.
struct VertexShares {
  std::vector<std::uint32_t> begin;  // vertices + 1
  std::vector<PatchShare> shares;

  std::span<const PatchShare> of(std::uint32_t vertex) const {
    return std::span(shares).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// The extent of patches beyond the borders of their cells.
struct Overlap {
  double width = 0.03;        // maximum, sizes; noise makes it irregular
  double area_factor = 1.25;  // maximum area of all patch triangles over the surface's, if one triangle ring permits
};

/// Returns the shares of patches at vertices. The weight of a patch is 1 in its own cell and falls with the distance
/// from it to 0 at the overlap's width; shares are normalised weights. The width is the largest that keeps the area
/// factor. A patch always includes the ring of triangles that touch its cell. Deterministic.
VertexShares share_vertices(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, const Overlap& overlap);

/// Writes the patches of a triangle: those with a share at a corner, rising, each once.
void patches_at(const VertexShares& shares, const glm::uvec3& triangle, std::vector<std::uint32_t>& patches);

}  // namespace pelage
