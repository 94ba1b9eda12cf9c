#include "tests/property/groom/reference/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::plain {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Distance of corner `c` from a source that is `da` and `db` away from corners `a` and `b`. All are unfolded into one
/// plane with a at 0 and b on the x axis, c above and the source below. Infinite if the straight line misses the side
/// ab.
double over_side(dvec3 a, dvec3 b, dvec3 c, double da, double db) {
  const double side = glm::distance(a, b);
  const dvec3 x = (b - a) / side;
  const dvec2 position(glm::dot(c - a, x), glm::length(glm::cross(x, c - a)));
  const double source_x = (da * da - db * db + side * side) / (2 * side), under = da * da - source_x * source_x;
  const bool on_side = std::abs(under) < 1e-12 * (da * da + db * db + side * side);  // within rounding
  if ((under < 0 && !on_side) || position.y <= 0) return never;
  const dvec2 source(source_x, on_side ? 0 : -std::sqrt(under));
  const double crossing = source.x + (position.x - source.x) * (0 - source.y) / (position.y - source.y);
  return crossing < 0 || crossing > side ? never : glm::distance(source, position);
}

/// The vertex with the smallest distance that is not final; any final one if all are.
Vertex nearest_open(const std::vector<double>& distances, const std::vector<bool>& final) {
  Vertex best = 0;
  for (Vertex v = 1; v < distances.size(); ++v) {
    if (final[best] || (!final[v] && distances[v] < distances[best])) best = v;
  }
  return best;
}

}  // namespace

std::set<Vertex> corners_of(const Body& body, const SurfacePoint& point) {
  std::set<Vertex> holders, corners;
  for (int k = 0; k < 3; ++k) {
    if (point.barycentric[k] > 1e-6) holders.insert(body.triangles[point.triangle][static_cast<std::size_t>(k)]);
  }
  if (holders.size() == 1) return holders;
  for (const auto& triangle : body.triangles) {
    const std::set<Vertex> own(triangle.begin(), triangle.end());
    if (std::includes(own.begin(), own.end(), holders.begin(), holders.end())) corners.insert(own.begin(), own.end());
  }
  return corners;
}

Reach reach_along_edges(const Body& body, const std::vector<Corner>& corners) {
  Reach reach{std::vector<double>(body.size(), never), std::vector<dvec3>(body.size(), dvec3(0))};
  for (const Corner& corner : corners) {
    if (corner.distance >= reach.distance[corner.vertex]) continue;
    reach.distance[corner.vertex] = corner.distance;
    reach.vector[corner.vertex] = corner.vector;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (Vertex v = 0; v < body.size(); ++v) {
      for (const Vertex other : body.neighbours[v]) {
        const double by = reach.distance[other] + glm::distance(body.positions[v], body.positions[other]);
        if (by >= reach.distance[v]) continue;
        reach.distance[v] = by;
        reach.vector[v] = brought(reach.vector[other], body.normals[other], body.normals[v]);
        changed = true;
      }
    }
  }
  return reach;
}

Reach reach_through_space(const Body& body, const std::vector<Corner>& corners) {
  Reach reach{std::vector<double>(body.size(), never), std::vector<dvec3>(body.size(), dvec3(0))};
  for (Vertex v = 0; v < body.size(); ++v) {
    for (const Corner& corner : corners) {
      const double by = corner.distance + glm::distance(body.positions[corner.vertex], body.positions[v]);
      if (by >= reach.distance[v]) continue;
      reach.distance[v] = by;
      reach.vector[v] = brought(corner.vector, body.normals[corner.vertex], body.normals[v]);
    }
  }
  return reach;
}

std::vector<double> marched_distances(const Body& body, const SurfacePoint& centre, double radius) {
  std::vector<double> distances(body.size(), never);
  std::vector<bool> final(body.size(), false), settled(body.size(), false);
  const dvec3 start = body.surface.position(centre);
  for (const Vertex v : corners_of(body, centre))
    distances[v] = glm::distance(start, body.positions[v]), settled[v] = true;
  for (;;) {
    const Vertex next = nearest_open(distances, final);
    if (final[next] || distances[next] == never) return distances;
    final[next] = settled[next] = true;
    for (const Vertex to : body.neighbours[next]) {
      if (settled[to]) continue;
      double length = distances[next] + glm::distance(body.positions[next], body.positions[to]);
      for (const Vertex other : body.neighbours[to]) {
        if (!settled[other] || other == next || !body.neighbours[next].contains(other)) continue;
        length = std::min(length, over_side(body.positions[next], body.positions[other], body.positions[to],
                                            distances[next], distances[other]));
      }
      if (distances[next] <= radius || length <= radius) distances[to] = std::min(distances[to], length);
    }
  }
}

std::vector<double> gaussians(const std::vector<double>& distances, double sigma) {
  std::vector<double> weights(distances.size(), 0.0);
  const double nearest = *std::min_element(distances.begin(), distances.end());
  double sum = 0;
  for (std::size_t k = 0; k < distances.size() && nearest < never; ++k) {
    if (distances[k] == never) continue;
    const long double d = distances[k], n = nearest, s = sigma;
    weights[k] = static_cast<double>(std::exp(-(d * d - n * n) / (2 * s * s)));
    sum += weights[k];
  }
  for (double& weight : weights) weight = sum > 0 ? weight / sum : 0;
  return weights;
}

}  // namespace pelage::plain
