#include "server/surface/local_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "server/surface/corners_around.h"

namespace pelage {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Marches outwards from the corners of one triangle.
class March {
 public:
  March(const Surface& surface, double radius) : surface_(surface), radius_(radius) {}

  /// Nothing is nearer to the corners around the centre than the straight way.
  void start(const SurfacePoint& centre) {
    const glm::dvec3 place = surface_.position(centre);
    for (const std::uint32_t corner : corners_around(surface_, centre)) {
      offer(corner, glm::distance(place, position(corner)));
      known_[corner].settled = true;
    }
  }

  void run() {
    while (!front_.empty()) {
      const auto [distance, vertex] = front_.top();
      front_.pop();
      Known& known = known_[vertex];
      if (known.final || distance > known.distance) continue;
      known.settled = known.final = true;
      // One ring beyond the radius is marched too: the straight way to a vertex inside it may pass between one vertex
      // inside and one outside.
      for (const std::uint32_t next : surface_.neighbours(vertex)) {
        const double there = distance_by(vertex, distance, next);
        if (distance <= radius_ || there <= radius_) offer(next, there);
      }
    }
  }

  std::vector<VertexDistance> found() const {
    std::vector<VertexDistance> all;
    for (const auto& [vertex, known] : known_) {
      if (known.distance <= radius_) all.push_back({vertex, known.distance});
    }
    std::sort(all.begin(), all.end(), [](auto a, auto b) { return a.vertex < b.vertex; });
    return all;
  }

 private:
  struct Known {
    double distance = unreached;
    bool settled = false;  // it will not change
    bool final = false;    // and its neighbours have been offered theirs
  };
  using Place = std::pair<double, std::uint32_t>;

  glm::dvec3 position(std::uint32_t v) const { return glm::dvec3(surface_.mesh().positions[v]); }

  void offer(std::uint32_t vertex, double distance) {
    Known& known = known_[vertex];
    if (known.settled || known.distance <= distance) return;
    known.distance = distance;
    front_.push({distance, vertex});
  }

  /// The way to `next` from the vertex that became final: along the edge, or across a triangle at it.
  double distance_by(std::uint32_t vertex, double distance, std::uint32_t next) const {
    const double near = glm::distance(position(vertex), position(next));
    double best = distance + near;
    for (const std::uint32_t other : surface_.neighbours(next)) {
      const auto known = known_.find(other);
      if (other == vertex || known == known_.end() || !known->second.settled || !adjacent(other, vertex)) continue;
      best = std::min(best, unfolded_distance(glm::distance(position(vertex), position(other)), near,
                                              glm::distance(position(other), position(next)), distance,
                                              known->second.distance));
    }
    return best;
  }

  bool adjacent(std::uint32_t a, std::uint32_t b) const {
    const auto others = surface_.neighbours(a);
    return std::binary_search(others.begin(), others.end(), b);
  }

  const Surface& surface_;
  double radius_;
  std::unordered_map<std::uint32_t, Known> known_;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> front_;
};

}  // namespace

double unfolded_distance(double along, double near, double far, double near_distance, double far_distance) {
  if (!(along > 0)) return unreached;
  // The edge lies on the x axis from the near corner; the source is below it, the place above.
  const double source_x = (near_distance * near_distance - far_distance * far_distance + along * along) / (2 * along);
  const double depth = near_distance * near_distance - source_x * source_x;
  const double place_x = (near * near - far * far + along * along) / (2 * along);
  const double height = near * near - place_x * place_x;
  // Rounding may put a source that lies on the edge itself a little above it.
  const double rounding = 1e-12 * (near_distance * near_distance + far_distance * far_distance + along * along);
  if (depth < -rounding || !(height > 0)) return unreached;
  const double below = std::sqrt(std::max(depth, 0.0)), above = std::sqrt(height);
  const double crossing = source_x + (place_x - source_x) * below / (below + above);
  if (crossing < 0 || crossing > along) return unreached;
  return std::hypot(place_x - source_x, below + above);
}

std::vector<VertexDistance> distances_within(const Surface& surface, const SurfacePoint& centre, double radius) {
  March march(surface, radius);
  march.start(centre);
  march.run();
  return march.found();
}

}  // namespace pelage
