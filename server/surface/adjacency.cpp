#include "server/surface/adjacency.h"

#include <algorithm>
#include <tuple>

namespace pelage {

std::vector<Side> sorted_sides(const std::vector<glm::uvec3>& triangles) {
  std::vector<Side> sides;
  sides.reserve(triangles.size() * 3);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][static_cast<int>(k)], b = triangles[t][static_cast<int>((k + 1) % 3)];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
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
