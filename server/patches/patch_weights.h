// How much each patch counts at each vertex: soft overlaps whose weights sum to 1 everywhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/patches/patch_cells.h"

namespace pelage {

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

/// How far patches reach over the borders of their cells.
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
