#include "server/first_groom/poles.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace pelage {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Along edges from all of `sources`, by vertex of the mesh.
std::vector<double> distances_from(const Mesh& mesh, const Adjacency& edges, std::span<const std::uint32_t> sources) {
  using Place = std::pair<double, std::uint32_t>;
  std::vector<double> distances(mesh.positions.size(), unreached);
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open;
  for (const std::uint32_t v : sources) distances[v] = 0, open.emplace(0, v);
  while (!open.empty()) {
    const auto [distance, v] = open.top();
    open.pop();
    if (distance > distances[v]) continue;
    for (const std::uint32_t other : edges.of(v)) {
      const double there = distance + glm::distance(glm::dvec3(mesh.positions[v]), glm::dvec3(mesh.positions[other]));
      if (there < distances[other]) distances[other] = there, open.emplace(there, other);
    }
  }
  return distances;
}

/// All vertices whose score is the best but for rounding: both of a pair of a symmetric model.
template <class Score>
std::vector<std::uint32_t> best_of(std::span<const std::uint32_t> vertices, const Score& score) {
  constexpr double rounding = 1e-4;
  double best = -unreached;
  for (const std::uint32_t v : vertices) best = std::max(best, score(v));
  std::vector<std::uint32_t> found;
  for (const std::uint32_t v : vertices) {
    if (score(v) >= best - rounding) found.push_back(v);
  }
  return found;
}

std::vector<std::uint32_t> within(std::span<const std::uint32_t> vertices, const std::vector<double>& distances,
                                  double radius) {
  std::vector<std::uint32_t> found;
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(found),
               [&](std::uint32_t v) { return distances[v] <= radius; });
  return found;
}

/// The diagonal of the part's box.
double size_of(const Mesh& mesh, std::span<const std::uint32_t> part) {
  glm::dvec3 low(unreached), high(-unreached);
  for (const std::uint32_t v : part)
    low = glm::min(low, glm::dvec3(mesh.positions[v])), high = glm::max(high, glm::dvec3(mesh.positions[v]));
  return glm::length(high - low);
}

/// Under the chin: the lowest place near the nose. Of what is in the middle from side to side rather.
std::vector<std::uint32_t> chin_of(const Mesh& mesh, const Adjacency& edges, std::span<const std::uint32_t> part) {
  constexpr double up = 0.35, aside = 0.2, reach = 0.16;  // the last of the part's size
  const auto face = [&](std::uint32_t v) {
    const glm::dvec3 p(mesh.positions[v]);
    return p.z + up * p.y - aside * std::abs(p.x);
  };
  const std::vector<std::uint32_t> nose = best_of(part, face);
  const std::vector<double> from_nose = distances_from(mesh, edges, nose);
  const auto low = [&](std::uint32_t v) {
    const glm::dvec3 p(mesh.positions[v]);
    return -p.y - aside * std::abs(p.x);
  };
  return best_of(within(part, from_nose, reach * size_of(mesh, part)), low);
}

/// A place that is farther than all around it.
struct Peak {
  std::uint32_t vertex = 0;
  double prominence = 0;  // how far one has to go back before the way leads on to something farther
};

/// By the persistence of super-level sets: from the farthest vertex on, what hangs together belongs to the farthest of
/// its peaks.
std::vector<Peak> peaks_of(const Adjacency& edges, std::span<const std::uint32_t> part,
                           const std::vector<double>& distances) {
  std::vector<std::uint32_t> order(part.begin(), part.end());
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distances[a] > distances[b]; });
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> peak(distances.size(), none);  // of each vertex that is in: itself, or one on the way
  const auto root = [&](std::uint32_t v) {
    while (peak[v] != v) v = peak[v] = peak[peak[v]];
    return v;
  };
  std::vector<Peak> found;
  for (const std::uint32_t v : order) {
    peak[v] = v;
    for (const std::uint32_t other : edges.of(v)) {
      if (peak[other] == none) continue;
      std::uint32_t a = root(v), b = root(other);
      if (a == b) continue;
      if (distances[a] < distances[b] || (distances[a] == distances[b] && a > b)) std::swap(a, b);
      if (b != v) found.push_back({b, distances[b] - distances[v]});
      peak[b] = a;
    }
  }
  if (!order.empty()) found.push_back({order.front(), distances[order.front()]});
  return found;
}

/// The place near a peak that shows least: low and at the back.
std::vector<std::uint32_t> hidden_end(const Mesh& mesh, std::span<const std::uint32_t> part,
                                      const std::vector<double>& from_peak, const Peak& peak, double size) {
  constexpr double share = 0.25, reach = 0.1, behind = 0.3, aside = 0.05;
  const double radius = std::min(share * peak.prominence, reach * size);
  return best_of(within(part, from_peak, radius), [&](std::uint32_t v) {
    const glm::dvec3 p(mesh.positions[v]);
    return -p.y - behind * p.z - aside * std::abs(p.x);
  });
}

void add_shared(std::vector<Pole>& poles, const std::vector<std::uint32_t>& vertices, double flux) {
  for (const std::uint32_t v : vertices) poles.push_back({v, flux / static_cast<double>(vertices.size())});
}

}  // namespace

std::vector<Pole> find_poles(const Mesh& mesh, const Adjacency& edges, std::span<const std::uint32_t> part) {
  constexpr double prominent = 0.1;  // sizes of the part
  const double size = size_of(mesh, part);
  const std::vector<std::uint32_t> chin = chin_of(mesh, edges, part);
  const std::vector<double> distances = distances_from(mesh, edges, chin);
  std::vector<Peak> ends = peaks_of(edges, part, distances);
  std::erase_if(ends, [&](const Peak& peak) { return peak.prominence < prominent * size; });
  double all = 0;
  for (const Peak& end : ends) all += distances[end.vertex] * distances[end.vertex];
  if (!(all > 0)) return {};
  std::vector<Pole> poles;
  add_shared(poles, chin, 1);
  for (const Peak& end : ends) {
    const std::vector<double> from_peak = distances_from(mesh, edges, std::span(&end.vertex, 1));
    const double flux = distances[end.vertex] * distances[end.vertex] / all;
    add_shared(poles, hidden_end(mesh, part, from_peak, end, size), -flux);
  }
  return poles;
}

}  // namespace pelage
