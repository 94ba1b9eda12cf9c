#include "server/surface/soup.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace pelage {

Placement place(const std::vector<glm::dvec3>& positions) {
  assert(!positions.empty());
  Placement placement;
  placement.low = placement.high = positions.front();
  for (const glm::dvec3& p : positions) {
    placement.low = glm::min(placement.low, p);
    placement.high = glm::max(placement.high, p);
  }
  const glm::dvec3 half = placement.high / 2.0 - placement.low / 2.0;
  placement.centre = placement.low + half;
  // Scaled by the longest side first, so that squares of tiny extents do not underflow.
  const double longest = 2 * glm::max(half.x, glm::max(half.y, half.z));
  placement.size = longest > 0 ? longest * glm::length(2.0 * half / longest) : 0;
  return placement;
}

std::size_t drop_repeated(Soup& soup) {
  std::vector<std::array<std::uint32_t, 4>> keys;  // sorted vertices, triangle
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<std::uint32_t, 4> key = {soup.triangles[t].x, soup.triangles[t].y, soup.triangles[t].z, t};
    std::sort(key.begin(), key.begin() + 3);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(keys.size(), false);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    repeated[keys[i][3]] = std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin());
  }
  Soup kept;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (!repeated[t]) kept.add(soup.triangles[t], soup.corners[t], soup.faces[t]);
  }
  const std::size_t dropped = soup.triangles.size() - kept.triangles.size();
  kept.positions = std::move(soup.positions);
  kept.sources = std::move(soup.sources);
  soup = std::move(kept);
  return dropped;
}

void drop_unused(Soup& soup) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> renumbered(soup.positions.size(), unused);
  for (const glm::uvec3& t : soup.triangles) renumbered[t.x] = renumbered[t.y] = renumbered[t.z] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == unused) continue;
    soup.positions[count] = soup.positions[v];
    soup.sources[count] = soup.sources[v];
    renumbered[v] = count++;
  }
  soup.positions.resize(count);
  soup.sources.resize(count);
  for (glm::uvec3& t : soup.triangles) t = {renumbered[t.x], renumbered[t.y], renumbered[t.z]};
}

std::size_t count_parts(const Soup& soup) {
  std::vector<std::uint32_t> parent(soup.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t parts = soup.positions.size();
  for (const glm::uvec3& t : soup.triangles) {
    for (int k = 1; k < 3; ++k) {
      const std::uint32_t a = root(t[0]), b = root(t[k]);
      if (a == b) continue;
      parent[std::max(a, b)] = std::min(a, b);
      --parts;
    }
  }
  return parts;
}

}  // namespace pelage
