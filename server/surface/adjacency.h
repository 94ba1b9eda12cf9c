// Which vertices share an edge, and which triangles share one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// For each item a run of others, one after the other in one array.
struct Adjacency {
  std::vector<std::uint32_t> begin;  // items + 1
  std::vector<std::uint32_t> others;

  std::span<const std::uint32_t> of(std::uint32_t item) const {
    return std::span(others).subspan(begin[item], begin[item + 1] - begin[item]);
  }
};

/// Vertices that share an edge with each vertex, in rising order, each once.
Adjacency vertex_neighbours(const std::vector<glm::uvec3>& triangles, std::size_t vertices);

/// One side of a triangle: from corner `side` to the next.
struct Side {
  std::uint32_t low, high;  // its vertices
  std::uint32_t triangle;
  std::uint32_t side;  // 0, 1, 2
  bool rising;         // whether the triangle runs from low to high
};

/// All sides, those of one edge beside each other, in rising order of (low, high, triangle, side).
std::vector<Side> sorted_sides(const std::vector<glm::uvec3>& triangles);

/// Calls `visit(std::span<const Side>)` for each edge of `sides` in order.
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
