// Adjacency of a mesh: the neighbours of vertices, and the triangles at each edge.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Lists of neighbours for each item, stored one after the other in one array.
struct Adjacency {
  std::vector<std::uint32_t> begin;  // offsets into `others`; number of items + 1
  std::vector<std::uint32_t> others;

  std::span<const std::uint32_t> of(std::uint32_t item) const {
    return std::span(others).subspan(begin[item], begin[item + 1] - begin[item]);
  }
};

/// Returns for each vertex the vertices that share an edge with it, sorted, each once.
Adjacency vertex_neighbours(const std::vector<glm::uvec3>& triangles, std::size_t vertices);

/// One side of a triangle: from corner `side` to the next.
struct Side {
  std::uint32_t low, high;  // its vertices, low < high
  std::uint32_t triangle;
  std::uint32_t side;  // 0, 1, 2
  bool rising;         // true if the triangle's winding runs from low to high
};

/// Returns all sides, sorted by (low, high, triangle, side), so that the sides of one edge are adjacent.
std::vector<Side> sorted_sides(const std::vector<glm::uvec3>& triangles);

/// Calls `visit(std::span<const Side>)` for each edge of the sorted `sides`, in order.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    visit(std::span(sides).subspan(i, end - i));
    i = end;
  }
}

}  // namespace pelage
