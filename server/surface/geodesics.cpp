#include "server/surface/geodesics.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <unordered_map>

#include "base/parallel.h"

namespace pelage {

namespace {

/// Returns whether the ends of an edge, with a position on it, and a third vertex are the corners of a triangle. Three
/// vertices that are neighbours of each other need not be: they may go around a tube.
bool is_triangle(const Surface& surface, glm::uvec2 edge, glm::dvec3 point, std::uint32_t third) {
  constexpr double inside = 0.25;
  const glm::dvec3 within = glm::mix(point, glm::dvec3(surface.mesh().positions[third]), inside);
  const glm::uvec3 found = surface.mesh().triangles[surface.nearest(within).triangle];
  const auto has = [&](std::uint32_t v) { return found.x == v || found.y == v || found.z == v; };
  return has(edge.x) && has(edge.y) && has(third);
}

}  // namespace

std::vector<std::uint32_t> corners_around(const Surface& surface, const SurfacePoint& point) {
  constexpr double on_edge = 1e-6;  // barycentric
  const glm::uvec3 triangle = surface.mesh().triangles[point.triangle];
  std::vector<std::uint32_t> corners{triangle.x, triangle.y, triangle.z}, holders;
  for (int k = 0; k < 3; ++k) {
    if (point.barycentric[k] > on_edge) holders.push_back(triangle[k]);
  }
  if (holders.size() == 1) return holders;
  if (holders.size() != 2) return corners;
  const auto others = surface.neighbours(holders[1]);
  for (const std::uint32_t next : surface.neighbours(holders[0])) {
    if (!std::binary_search(others.begin(), others.end(), next)) continue;
    if (std::find(corners.begin(), corners.end(), next) != corners.end()) continue;
    if (is_triangle(surface, {holders[0], holders[1]}, surface.position(point), next)) corners.push_back(next);
  }
  return corners;
}

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

Spread unreached_spread(std::size_t vertices) {
  return {std::vector<double>(vertices, unreached), std::vector<glm::dvec3>(vertices, glm::dvec3(0))};
}

/// Returns the sources that are nearest at their vertices, sorted by distance, and stores their distances and vectors.
std::vector<MonotoneQueue::Entry> seed_entries(std::span<const SpreadSource> sources, Spread& spread) {
  std::vector<MonotoneQueue::Entry> entries;
  for (const SpreadSource& source : sources) {
    if (!(source.distance < spread.distance[source.vertex])) continue;
    spread.distance[source.vertex] = source.distance, spread.vector[source.vertex] = source.vector;
    entries.emplace_back(source.distance, source.vertex);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

EdgeSearch::EdgeSearch(const Surface& surface) : surface_(surface) {
  const std::vector<glm::vec3>& positions = surface.mesh().positions;
  const Adjacency& edges = surface.adjacency();
  lengths_.resize(edges.others.size());
  for_each_range_in_parallel(static_cast<std::uint32_t>(positions.size()), [&](std::uint32_t begin, std::uint32_t end) {
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
  constexpr double bands_a_step = 4, max_bands = 1 << 14;  // narrow, but few enough to scan
  const std::vector<glm::vec3>& normals = surface_.mesh().normals;
  const Adjacency& edges = surface_.adjacency();
  Spread spread = unreached_spread(normals.size());
  const std::vector<MonotoneQueue::Entry> starts = seed_entries(sources, spread);
  if (lengths_.empty()) return spread;
  std::vector<std::uint32_t> before(
      normals.size());  // the previous vertex on the shortest path; the vertex itself at sources
  for (const auto& [distance, vertex] : starts) before[vertex] = vertex;
  MonotoneQueue front(std::max(mean_ / bands_a_step, longest_ / max_bands), longest_);
  for (auto start = starts.begin(); start != starts.end() || !front.empty();) {
    for (; start != starts.end() && (front.empty() || start->first <= front.min()); ++start)
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
  Spread spread = unreached_spread(mesh.positions.size());
  for_each_range_in_parallel(
      static_cast<std::uint32_t>(mesh.positions.size()), [&](std::uint32_t begin, std::uint32_t end) {
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

namespace {

/// Fast marching outwards from the corners around a point.
class March {
 public:
  March(const Surface& surface, double radius) : surface_(surface), radius_(radius) {}

  /// Sets the distances of the corners around the centre, for which the straight path is the shortest.
  void start(const SurfacePoint& centre) {
    const glm::dvec3 point = surface_.position(centre);
    for (const std::uint32_t corner : corners_around(surface_, centre)) {
      offer(corner, glm::distance(point, position(corner)));
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
      // Marches one ring beyond the radius, because the shortest path to a vertex inside it may pass between one vertex
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
    bool settled = false;  // the distance will not change
    bool final = false;    // and its neighbours have been updated
  };
  using Entry = std::pair<double, std::uint32_t>;

  glm::dvec3 position(std::uint32_t v) const { return glm::dvec3(surface_.mesh().positions[v]); }

  void offer(std::uint32_t vertex, double distance) {
    Known& known = known_[vertex];
    if (known.settled || known.distance <= distance) return;
    known.distance = distance;
    front_.push({distance, vertex});
  }

  /// Returns the distance to `next` from the vertex that became final: along the edge, or across a triangle at it.
  double distance_by(std::uint32_t vertex, double distance, std::uint32_t next) const {
    const double near = glm::distance(position(vertex), position(next));
    double best = distance + near;
    for (const std::uint32_t other : surface_.neighbours(next)) {
      const auto known = known_.find(other);
      if (other == vertex || known == known_.end() || !known->second.settled || !adjacent(other, vertex)) continue;
      best = std::min(
          best, unfolded_distance(glm::distance(position(vertex), position(other)), near,
                                  glm::distance(position(other), position(next)), distance, known->second.distance));
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
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

}  // namespace

double unfolded_distance(double along, double near, double far, double near_distance, double far_distance) {
  if (!(along > 0)) return unreached;
  // In the unfolded plane the edge lies on the x axis from its near end; the source is below it, the corner above.
  const double source_x = (near_distance * near_distance - far_distance * far_distance + along * along) / (2 * along);
  const double depth = near_distance * near_distance - source_x * source_x;
  const double corner_x = (near * near - far * far + along * along) / (2 * along);
  const double height = near * near - corner_x * corner_x;
  // Rounding may put a source on the edge slightly above it.
  const double rounding = 1e-12 * (near_distance * near_distance + far_distance * far_distance + along * along);
  if (depth < -rounding || !(height > 0)) return unreached;
  const double below = std::sqrt(std::max(depth, 0.0)), above = std::sqrt(height);
  const double crossing = source_x + (corner_x - source_x) * below / (below + above);
  if (crossing < 0 || crossing > along) return unreached;
  return std::hypot(corner_x - source_x, below + above);
}

std::vector<VertexDistance> distances_within(const Surface& surface, const SurfacePoint& centre, double radius) {
  March march(surface, radius);
  march.start(centre);
  march.run();
  return march.found();
}

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// Minimum length scale of the heat, which falls like exp(-distance / reach). A shorter one would underflow double on
/// the far side.
constexpr double min_reach = 1.0 / 200;
/// Added to the diagonal; makes the Laplacian of every connected part invertible.
constexpr double regularisation = 1e-9;

/// A triangle's corners, its area, and the gradients of the corners' hat functions.
struct Element {
  glm::uvec3 corners{0};
  double area = 0;
  glm::dvec3 gradients[3] = {};
};

std::vector<Element> elements_of(const Mesh& mesh) {
  std::vector<Element> elements;
  elements.reserve(mesh.triangles.size());
  for (const glm::uvec3& corners : mesh.triangles) {
    const glm::dvec3 p[3] = {glm::dvec3(mesh.positions[corners.x]), glm::dvec3(mesh.positions[corners.y]),
                             glm::dvec3(mesh.positions[corners.z])};
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double twice = glm::length(cross);
    const double longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    constexpr double thinnest = 1e-8;  // height relative to the longest side
    if (!(twice > thinnest * longest * longest)) continue;
    Element element{corners, twice / 2, {}};
    for (int k = 0; k < 3; ++k)
      element.gradients[k] = glm::cross(cross / twice, p[(k + 2) % 3] - p[(k + 1) % 3]) / twice;
    elements.push_back(element);
  }
  return elements;
}

/// Returns the mean length over all sides of all triangles, which does not depend on the order of corners.
double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sum += glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
  }
  return mesh.triangles.empty() ? 1 : sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

/// Returns the number of each vertex's connected part.
std::vector<std::uint32_t> parts_of(const Surface& surface) {
  constexpr auto unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> parts(surface.mesh().positions.size(), unknown), front;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < parts.size(); ++first) {
    if (parts[first] != unknown) continue;
    parts[first] = count, front.push_back(first);
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t next : surface.neighbours(v)) {
        if (parts[next] == unknown) parts[next] = count, front.push_back(next);
      }
    }
    ++count;
  }
  return parts;
}

}  // namespace

struct HeatDistance::Impl {
  std::vector<Element> elements;
  std::vector<std::uint32_t> parts;
  Eigen::SimplicialLDLT<Matrix> flow, laplacian;

  explicit Impl(const Surface& surface);
  Vector divergence(const Vector& heat) const;
};

HeatDistance::Impl::Impl(const Surface& surface) : elements(elements_of(surface.mesh())), parts(parts_of(surface)) {
  const auto size = static_cast<Eigen::Index>(surface.mesh().positions.size());
  const double reach = std::max(mean_edge(surface.mesh()), min_reach);
  std::vector<Eigen::Triplet<double>> stiffness, mass;
  for (const Element& element : elements) {
    for (int i = 0; i < 3; ++i) {
      mass.emplace_back(element.corners[i], element.corners[i], element.area / 3);
      for (int k = 0; k < 3; ++k)
        stiffness.emplace_back(element.corners[i], element.corners[k],
                               element.area * glm::dot(element.gradients[i], element.gradients[k]));
    }
  }
  for (Eigen::Index v = 0; v < size; ++v) {  // keeps vertices of no triangle from making the matrices singular
    mass.emplace_back(v, v, 1e-12);
    stiffness.emplace_back(v, v, regularisation);
  }
  Matrix masses(size, size), stiff(size, size);
  masses.setFromTriplets(mass.begin(), mass.end());
  stiff.setFromTriplets(stiffness.begin(), stiffness.end());
  flow.compute(masses + reach * reach * stiff);
  laplacian.compute(stiff);
}

/// Returns the divergence of the normalized negative gradient of the heat.
Vector HeatDistance::Impl::divergence(const Vector& heat) const {
  Vector divergence = Vector::Zero(heat.size());
  for (const Element& element : elements) {
    glm::dvec3 gradient(0);
    for (int k = 0; k < 3; ++k) gradient += heat[element.corners[k]] * element.gradients[k];
    const double largest = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
    if (!(largest > 0)) continue;
    const glm::dvec3 away = -glm::normalize(gradient / largest);
    for (int k = 0; k < 3; ++k) divergence[element.corners[k]] += element.area * glm::dot(element.gradients[k], away);
  }
  return divergence;
}

HeatDistance::HeatDistance(const Surface& surface) : impl_(std::make_unique<Impl>(surface)) {}
HeatDistance::~HeatDistance() = default;

std::vector<double> HeatDistance::operator()(std::span<const SpreadSource> sources) const {
  std::vector<double> distances(impl_->parts.size(), std::numeric_limits<double>::infinity());
  Vector heat = Vector::Zero(static_cast<Eigen::Index>(distances.size()));
  for (const SpreadSource& source : sources) heat[source.vertex] = 1;
  heat = impl_->flow.solve(heat);
  const Vector potential = impl_->laplacian.solve(impl_->divergence(heat));
  // The potential is determined up to a constant on each part, which the sources' own distances fix.
  std::vector<double> offsets(distances.size(), std::numeric_limits<double>::infinity());
  for (const SpreadSource& source : sources) {
    double& offset = offsets[impl_->parts[source.vertex]];
    offset = std::min(offset, potential[source.vertex] - source.distance);
  }
  for (std::size_t v = 0; v < distances.size(); ++v)
    distances[v] = std::max(0.0, potential[static_cast<Eigen::Index>(v)] - offsets[impl_->parts[v]]);
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (!std::isfinite(offsets[impl_->parts[v]])) distances[v] = std::numeric_limits<double>::infinity();
  }
  for (const SpreadSource& source : sources)
    distances[source.vertex] = std::min(distances[source.vertex], source.distance);
  return distances;
}

}  // namespace pelage
