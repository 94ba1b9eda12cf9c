#include "server/surface/adjacency.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pelage {

namespace {

template <class Visit>
void for_each_side(const std::vector<glm::uvec3>& triangles, const Visit& visit) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][static_cast<int>(k)], b = triangles[t][static_cast<int>((k + 1) % 3)];
      visit(Side{std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
}

}  // namespace

// Sorts by the lower vertex with a counting sort, then sorts the few sides of each vertex.
std::vector<Side> sorted_sides(const std::vector<glm::uvec3>& triangles) {
  std::uint32_t max = 0;
  for (const glm::uvec3& t : triangles) max = std::max({max, t.x, t.y, t.z});
  std::vector<std::size_t> begin(std::size_t{max} + 2, 0);
  for_each_side(triangles, [&](const Side& side) { ++begin[side.low + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  std::vector<Side> sides(triangles.size() * 3);
  for_each_side(triangles, [&](const Side& side) { sides[next[side.low]++] = side; });
  const auto at = [&](std::size_t i) { return sides.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t low = 0; low <= max; ++low) {
    std::sort(at(begin[low]), at(begin[low + 1]), [](const Side& a, const Side& b) {
      return std::tie(a.high, a.triangle, a.side) < std::tie(b.high, b.triangle, b.side);
    });
  }
  return sides;
}

Adjacency vertex_neighbours(const std::vector<glm::uvec3>& triangles, std::size_t vertices) {
  const std::vector<Side> sides = sorted_sides(triangles);
  Adjacency adjacency;
  adjacency.begin.assign(vertices + 1, 0);
  for_each_edge(sides, [&](std::span<const Side> edge) {
    ++adjacency.begin[edge[0].low + 1];
    ++adjacency.begin[edge[0].high + 1];
  });
  for (std::size_t v = 0; v < vertices; ++v) adjacency.begin[v + 1] += adjacency.begin[v];
  adjacency.others.resize(adjacency.begin.back());
  std::vector<std::uint32_t> next(adjacency.begin.begin(), adjacency.begin.end() - 1);
  for_each_edge(sides, [&](std::span<const Side> edge) {
    adjacency.others[next[edge[0].low]++] = edge[0].high;
    adjacency.others[next[edge[0].high]++] = edge[0].low;
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(adjacency.others.begin() + adjacency.begin[v], adjacency.others.begin() + adjacency.begin[v + 1]);
  }
  return adjacency;
}

}  // namespace pelage
