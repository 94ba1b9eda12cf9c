#include "server/groom/poles.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace pelage {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr std::uint32_t no_peak = 0xffffffff;

/// Returns all vertices with the best score up to rounding, so that a symmetric model gives both vertices of a pair.
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

/// Returns the diagonal of the part's box.
double size_of(const Mesh& mesh, std::span<const std::uint32_t> part) {
  glm::dvec3 low(unreached), high(-unreached);
  for (const std::uint32_t v : part)
    low = glm::min(low, glm::dvec3(mesh.positions[v])), high = glm::max(high, glm::dvec3(mesh.positions[v]));
  return glm::length(high - low);
}

void add_shared(std::vector<Pole>& poles, const std::vector<std::uint32_t>& vertices, double flux) {
  for (const std::uint32_t v : vertices) poles.push_back({v, flux / static_cast<double>(vertices.size())});
}

}  // namespace

PoleFinder::Walk::Walk(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel)
    : mesh_(mesh), edges_(edges), cancel_(cancel), distances_(mesh.positions.size(), unreached) {}

const std::vector<std::uint32_t>& PoleFinder::Walk::from(std::span<const std::uint32_t> sources, double farthest) {
  constexpr std::size_t often = 0x3fff;
  using Entry = std::pair<double, std::uint32_t>;
  for (const std::uint32_t v : reached_) distances_[v] = unreached;
  reached_.clear();
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](std::uint32_t v, double distance) {
    if (distance > farthest || !(distance < distances_[v])) return;
    if (distances_[v] == unreached) reached_.push_back(v);
    distances_[v] = distance, queue.emplace(distance, v);
  };
  for (const std::uint32_t v : sources) reach(v, 0);
  for (std::size_t steps = 1; !queue.empty(); ++steps) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if ((steps & often) == 0) cancel_.check();
    if (distance > distances_[v]) continue;
    for (const std::uint32_t other : edges_.of(v))
      reach(other, distance + glm::distance(glm::dvec3(mesh_.positions[v]), glm::dvec3(mesh_.positions[other])));
  }
  std::sort(reached_.begin(), reached_.end());
  return reached_;
}

/// A local maximum of the distance from the chin.
struct PoleFinder::Peak {
  std::uint32_t vertex = 0;
  double prominence = 0;  // how far the distance must fall on any path to a farther peak
};

PoleFinder::PoleFinder(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel)
    : mesh_(mesh),
      edges_(edges),
      from_chin_(mesh, edges, cancel),
      near_(mesh, edges, cancel),
      peak_(mesh.positions.size(), no_peak) {}

/// Returns the lowest vertices near the nose, with a preference for the middle plane x = 0.
std::vector<std::uint32_t> PoleFinder::chin_of(std::span<const std::uint32_t> part, double size) {
  constexpr double up = 0.35, aside = 0.2, reach = 0.16;  // the last one in sizes of the part
  const Vertices nose = best_of(part, [&](std::uint32_t v) {
    const glm::dvec3 p(mesh_.positions[v]);
    return p.z + up * p.y - aside * std::abs(p.x);
  });
  return best_of(near_.from(nose, reach * size), [&](std::uint32_t v) {
    const glm::dvec3 p(mesh_.positions[v]);
    return -p.y - aside * std::abs(p.x);
  });
}

/// Finds peaks by the persistence of superlevel sets: visiting vertices from the farthest to the nearest, each
/// connected set belongs to the farthest of its peaks.
std::vector<PoleFinder::Peak> PoleFinder::peaks_of(std::span<const std::uint32_t> part) {
  Vertices order(part.begin(), part.end());
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return from_chin_[a] > from_chin_[b]; });
  const auto root = [&](std::uint32_t v) {
    while (peak_[v] != v) v = peak_[v] = peak_[peak_[v]];
    return v;
  };
  std::vector<Peak> found;
  for (const std::uint32_t v : order) {
    peak_[v] = v;
    for (const std::uint32_t other : edges_.of(v)) {
      if (peak_[other] == no_peak) continue;
      std::uint32_t a = root(v), b = root(other);
      if (a == b) continue;
      if (from_chin_[a] < from_chin_[b] || (from_chin_[a] == from_chin_[b] && a > b)) std::swap(a, b);
      if (b != v) found.push_back({b, from_chin_[b] - from_chin_[v]});
      peak_[b] = a;
    }
  }
  if (!order.empty()) found.push_back({order.front(), from_chin_[order.front()]});
  for (const std::uint32_t v : part) peak_[v] = no_peak;
  return found;
}

/// Returns the vertices near a peak that are least visible: low and at the back. The distance between two peaks is at
/// least twice the prominence of the lower one, so no vertex is near both.
std::vector<std::uint32_t> PoleFinder::hidden_end(const Peak& peak, double size) {
  constexpr double share = 0.25, reach = 0.1, behind = 0.3, aside = 0.05;
  const double radius = std::min(share * peak.prominence, reach * size);
  return best_of(near_.from(std::span(&peak.vertex, 1), radius), [&](std::uint32_t v) {
    const glm::dvec3 p(mesh_.positions[v]);
    return -p.y - behind * p.z - aside * std::abs(p.x);
  });
}

std::vector<Pole> PoleFinder::find(std::span<const std::uint32_t> part) {
  constexpr double prominent = 0.1;  // share of the part's size
  const double size = size_of(mesh_, part);
  const Vertices chin = chin_of(part, size);
  from_chin_.from(chin, unreached);
  std::vector<Peak> ends = peaks_of(part);
  std::erase_if(ends, [&](const Peak& peak) { return peak.prominence < prominent * size; });
  double all = 0;
  for (const Peak& end : ends) all += from_chin_[end.vertex] * from_chin_[end.vertex];
  if (!(all > 0)) return {};
  std::vector<Pole> poles;
  add_shared(poles, chin, 1);
  for (const Peak& end : ends)
    add_shared(poles, hidden_end(end, size), -from_chin_[end.vertex] * from_chin_[end.vertex] / all);
  return poles;
}

}  // namespace pelage
