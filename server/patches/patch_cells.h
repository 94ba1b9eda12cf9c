// The vertices of a surface in cells that can be flattened: the cores of patches before they overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// What growing needs to know about a mesh.
struct VertexGraph {
  Adjacency neighbours;              // of vertices
  std::vector<double> costs;         // of each entry of neighbours.others: what a step there costs, in sizes
  std::vector<double> vertex_areas;  // a third of the triangles around, size^2
};
VertexGraph make_vertex_graph(const Mesh& mesh);

/// A partition: every vertex is in one cell, every cell hangs together by edges and has a vertex.
struct Cells {
  std::vector<std::uint32_t> cell;  // of each vertex
  std::uint32_t count = 0;
};

/// How much a cell may hold.
struct CellLimits {
  double cone_degrees = 80;       // between the mean normal and those of 99% of the area
  std::size_t vertices = 10'000;  // so that flattening stays cheap
};

/// Cells as few and round as the limits allow: seeds are added where a cell bends too much, far from its own seed
/// (farthest-point sampling; steps cost length and bending), moved to the middle of their cells (Lloyd), and cells
/// merged again where the limits allow it. Borders are made irregular by noise. Deterministic; O(n log n) a round.
Cells partition(const Mesh& mesh, const VertexGraph& graph, const CellLimits& limits);

/// Members of each cell in rising order.
Adjacency members_of(const Cells& cells);

/// Splits a cell in two between the ends of its longest path; the second half becomes the last cell. A cell of one
/// vertex stays whole.
void split_cell(const VertexGraph& graph, Cells& cells, std::uint32_t cell);

/// The member nearest to the area-weighted middle of the members; the first of equals.
std::uint32_t middle_vertex(const Mesh& mesh, const VertexGraph& graph, std::span<const std::uint32_t> members);

}  // namespace pelage
