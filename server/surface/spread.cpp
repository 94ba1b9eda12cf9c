#include "server/surface/spread.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "server/surface/monotone_queue.h"
#include "protocol/base/parallel.h"
#include "server/surface/transport.h"

namespace pelage {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

Spread nothing_reached(std::size_t vertices) {
  return {std::vector<double>(vertices, unreached), std::vector<glm::dvec3>(vertices, glm::dvec3(0))};
}

/// Sources that count, nearest first; their vertices already have their distances and vectors.
std::vector<MonotoneQueue::Place> placed(std::span<const SpreadSource> sources, Spread& spread) {
  std::vector<MonotoneQueue::Place> places;
  for (const SpreadSource& source : sources) {
    if (!(source.distance < spread.distance[source.vertex])) continue;
    spread.distance[source.vertex] = source.distance, spread.vector[source.vertex] = source.vector;
    places.emplace_back(source.distance, source.vertex);
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

EdgeSearch::EdgeSearch(const Surface& surface) : surface_(surface) {
  const std::vector<glm::vec3>& positions = surface.mesh().positions;
  const Adjacency& edges = surface.adjacency();
  lengths_.resize(edges.others.size());
  for_each_run_in_parallel(static_cast<std::uint32_t>(positions.size()), [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      for (std::uint32_t e = edges.begin[v]; e < edges.begin[v + 1]; ++e)
        lengths_[e] = glm::distance(glm::dvec3(positions[v]), glm::dvec3(positions[edges.others[e]]));
    }
  });
  if (lengths_.empty()) return;
  mean_ = std::accumulate(lengths_.begin(), lengths_.end(), 0.0) / static_cast<double>(lengths_.size());
  longest_ = *std::max_element(lengths_.begin(), lengths_.end());
}

Spread EdgeSearch::operator()(std::span<const SpreadSource> sources) const {
  constexpr double bands_a_step = 4, most_bands = 1 << 14;  // narrow, but not so many that going through them counts
  const std::vector<glm::vec3>& normals = surface_.mesh().normals;
  const Adjacency& edges = surface_.adjacency();
  Spread spread = nothing_reached(normals.size());
  const std::vector<MonotoneQueue::Place> starts = placed(sources, spread);
  if (lengths_.empty()) return spread;
  std::vector<std::uint32_t> before(
      normals.size());  // the vertex that the way comes from; the vertex itself at sources
  for (const auto& [distance, vertex] : starts) before[vertex] = vertex;
  MonotoneQueue front(std::max(mean_ / bands_a_step, longest_ / most_bands), longest_);
  for (auto start = starts.begin(); start != starts.end() || !front.empty();) {
    for (; start != starts.end() && (front.empty() || start->first <= front.least()); ++start)
      front.push(start->first, start->second);
    const auto [distance, vertex] = front.pop();
    if (distance > spread.distance[vertex]) continue;
    const std::uint32_t last = before[vertex];
    if (last != vertex)
      spread.vector[vertex] = transported(spread.vector[last], glm::dvec3(normals[last]), glm::dvec3(normals[vertex]));
    for (std::uint32_t e = edges.begin[vertex]; e < edges.begin[vertex + 1]; ++e) {
      const std::uint32_t next = edges.others[e];
      const double there = distance + lengths_[e];
      if (!(there < spread.distance[next])) continue;
      spread.distance[next] = there, before[next] = vertex;
      front.push(there, next);
    }
  }
  return spread;
}

Spread spread_along_edges(const Surface& surface, std::span<const SpreadSource> sources) {
  return EdgeSearch(surface)(sources);
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
