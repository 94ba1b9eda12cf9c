#include "server/surface/spread.h"

#include <functional>
#include <limits>
#include <queue>

#include "server/surface/parallel.h"
#include "server/surface/transport.h"

namespace pelage {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

Spread nothing_reached(std::size_t vertices) {
  return {std::vector<double>(vertices, unreached), std::vector<glm::dvec3>(vertices, glm::dvec3(0))};
}

}  // namespace

Spread spread_along_edges(const Surface& surface, std::span<const SpreadSource> sources) {
  const Mesh& mesh = surface.mesh();
  Spread spread = nothing_reached(mesh.positions.size());
  using Place = std::pair<double, std::uint32_t>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> front;
  for (const SpreadSource& source : sources) {
    if (!(source.distance < spread.distance[source.vertex])) continue;
    spread.distance[source.vertex] = source.distance, spread.vector[source.vertex] = source.vector;
    front.push({source.distance, source.vertex});
  }
  while (!front.empty()) {
    const auto [distance, vertex] = front.top();
    front.pop();
    if (distance > spread.distance[vertex]) continue;
    const glm::dvec3 here(mesh.positions[vertex]), normal(mesh.normals[vertex]);
    for (const std::uint32_t next : surface.neighbours(vertex)) {
      const double there = distance + glm::distance(here, glm::dvec3(mesh.positions[next]));
      if (!(there < spread.distance[next])) continue;
      spread.distance[next] = there;
      spread.vector[next] = transported(spread.vector[vertex], normal, glm::dvec3(mesh.normals[next]));
      front.push({there, next});
    }
  }
  return spread;
}

Spread spread_through_space(const Surface& surface, std::span<const SpreadSource> sources) {
  const Mesh& mesh = surface.mesh();
  Spread spread = nothing_reached(mesh.positions.size());
  for_each_run_in_parallel(static_cast<std::uint32_t>(mesh.positions.size()), [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      for (const SpreadSource& source : sources) {
        const glm::dvec3 from(mesh.positions[source.vertex]);
        const double there = source.distance + glm::distance(from, glm::dvec3(mesh.positions[v]));
        if (!(there < spread.distance[v])) continue;
        spread.distance[v] = there;
        spread.vector[v] =
            transported(source.vector, glm::dvec3(mesh.normals[source.vertex]), glm::dvec3(mesh.normals[v]));
      }
    }
  });
  return spread;
}

}  // namespace pelage
