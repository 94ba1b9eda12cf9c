// Partitions the vertices of a surface into cells that can be flattened: the cores of patches before they overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// The vertices of a mesh as a graph on which cells grow.
struct VertexGraph {
  Adjacency neighbours;              // of vertices
  std::vector<double> costs;         // for each entry of neighbours.others: cost of the step to it, in sizes
  std::vector<double> vertex_areas;  // for each vertex: a third of the area of its triangles, size^2
};
VertexGraph make_vertex_graph(const Mesh& mesh);

/// A partition: every vertex is in one cell; every cell is connected by edges and has a vertex.
struct Cells {
  std::vector<std::uint32_t> cell;  // of each vertex
  std::uint32_t count = 0;
};

/// The limits of a cell.
struct CellLimits {
  double cone_degrees = 80;       // maximum angle between the mean normal and those of 99% of the area
  std::size_t vertices = 10'000;  // maximum, so that flattening stays cheap
};

/// Returns cells that are as few and round as the limits allow. Seeds are added to cells that bend too much, at the
/// vertex farthest from their seed (farthest-point sampling; steps cost length and bending), and moved to the middle of
/// their cells (Lloyd); then cells are merged if the limits allow it. Borders are made irregular by noise.
/// Deterministic; O(n log n) a round.
Cells partition(const Mesh& mesh, const VertexGraph& graph, const CellLimits& limits);

/// Returns the members of each cell in rising order.
Adjacency members_of(const Cells& cells);

/// Splits a cell in two between the ends of its longest path; the second half becomes the last cell. A cell of one
/// vertex stays whole.
void split_cell(const VertexGraph& graph, Cells& cells, std::uint32_t cell);

/// Returns the member nearest to the area-weighted centre of the members; the first one on ties.
std::uint32_t middle_vertex(const Mesh& mesh, const VertexGraph& graph, std::span<const std::uint32_t> members);

}  // namespace pelage
