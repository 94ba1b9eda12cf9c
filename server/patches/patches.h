// Where the sample tile lies on the surface: lapped patches (GPU fur 1; Praun et al. 2000). Laid once, when the model
// is prepared; combing turns the strands, not the map, so roots never move.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/base/status.h"
#include "server/patches/flatten.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A vertex as one patch has it.
struct PatchPoint {
  std::uint32_t vertex = 0;
  std::uint32_t patch = 0;
  glm::vec2 uv{0};       // place on the sample tile, sizes
  glm::vec3 axis{0};     // the way in space in which u grows there: unit, orthogonal to the vertex's normal
  float weight = 0;      // [0, 1]: share of the fur's optical depth
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

/// Whether the model has texture coordinates that span an area.
bool has_own_uvs(const Mesh& mesh);

/// The map that the model's own texture coordinates make: a patch for each of their islands, at the scale that keeps
/// the island's area; mirrored islands are turned over. One piece for each triangle, weight 1. Refused (invalid) when
/// the model has no texture coordinates that span an area.
Result<PatchMap> own_uv_patches(const Mesh& mesh);

/// How the map stretches a piece.
Stretch stretch_of(const Mesh& mesh, const PatchMap& map, const Piece& piece);

}  // namespace pelage
