// Distances over a surface from sources (edge search, straight through space, heat method), transport of directions
// along the paths, and the priority queue of the searches.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "server/surface/surface.h"

namespace pelage {

/// A priority queue that returns vertices by rising distance, and equally far ones by rising number, as a binary heap
/// of such pairs does. Nothing may be pushed nearer than what was popped last, or much farther. Distances are grouped
/// in bands; later bands are kept unsorted (Dial 1969), so that the heap of the current band stays small.
class MonotoneQueue {
 public:
  using Entry = std::pair<double, std::uint32_t>;

  /// Bands have the width `width`, above 0. Pushed distances are at most `reach` beyond what was popped last, except
  /// the first.
  MonotoneQueue(double width, double reach)
      : width_(width), bands_(static_cast<std::size_t>(std::ceil(reach / width)) + 3) {}

  bool empty() const { return count_ == 0; }

  void push(double distance, std::uint32_t vertex) {
    const auto band = static_cast<std::uint64_t>(distance / width_);
    if (count_++ == 0) band_ = band;
    assert(band < band_ + bands_.size());
    if (band > band_) {
      bands_[band % bands_.size()].emplace_back(distance, vertex);
      return;
    }
    near_.emplace_back(distance, vertex);
    std::push_heap(near_.begin(), near_.end(), std::greater<>());
  }

  /// Returns the smallest distance in the queue; infinite if it is empty.
  double min() {
    if (empty()) return std::numeric_limits<double>::infinity();
    while (near_.empty()) {
      near_.swap(bands_[++band_ % bands_.size()]);
      std::make_heap(near_.begin(), near_.end(), std::greater<>());
    }
    return near_.front().first;
  }

  /// Removes and returns the nearest vertex. The queue must not be empty.
  Entry pop() {
    min();
    std::pop_heap(near_.begin(), near_.end(), std::greater<>());
    const Entry point = near_.back();
    near_.pop_back();
    --count_;
    return point;
  }

 private:
  double width_;
  std::vector<std::vector<Entry>> bands_;  // indexed by band number modulo the number of bands
  std::vector<Entry> near_;                // heap of band `band_` and earlier ones
  std::uint64_t band_ = 0;
  std::size_t count_ = 0;
};

// Transport of a tangent vector from one vertex to another.

/// Returns the vector `v`, tangent to the unit normal `from`, rotated by the smallest rotation that takes `from` to the
/// unit normal `to`. Around a loop on which its errors add up to 1.7 degrees, those of a projection to the plane of
/// `to` add up to 49 (science.md 3). For tangent vectors that rotation is the reflection by the plane orthogonal to
/// from + to, which preserves the length however nearly opposite the normals are and however they are rounded; v -
/// (to.v) / (1 + d) (from + to), with d = dot(from, to), does not. For opposite normals there is no smallest rotation:
/// `v`, which lies in both planes, stays.
inline glm::dvec3 transported(glm::dvec3 v, glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 both = from + to;
  const double square = glm::dot(both, both);  // 2 (1 + d) with d = dot(from, to)
  constexpr double opposite = 2e-9;
  if (square < opposite) return v;
  return v - 2 * glm::dot(both, v) / square * both;
}

// The corners around a surface position.

/// Returns the vertices around a position: the corners of the triangle that contains it; on an edge the corners of all
/// its triangles; at a vertex that vertex alone. Queries may return any of the triangles that contain a position;
/// searches that start from these vertices do not depend on which.
std::vector<std::uint32_t> corners_around(const Surface& surface, const SurfacePoint& point);

// Distances over the whole surface from a set of sources, and transport of their directions.

/// A source of distances, given at a vertex near it.
struct SpreadSource {
  std::uint32_t vertex = 0;
  double distance = 0;   // distance from the source to the vertex, sizes
  glm::dvec3 vector{0};  // vector to transport, in the vertex's tangent plane
};

struct Spread {
  std::vector<double> distance;    // for each vertex, sizes; infinite if there is no path
  std::vector<glm::dvec3> vector;  // that of the nearest source, transported by smallest rotations along the path
};

/// Dijkstra's search along edges (fur modelling 5.1). It overestimates the distance along the surface, and subdividing
/// the mesh does not fix that. Edge lengths are computed once for all searches, which may run in parallel. Of several
/// shortest paths to a vertex it takes the one whose last step begins nearest to its source, and of those the one from
/// the vertex with the lowest number.
class EdgeSearch {
 public:
  explicit EdgeSearch(const Surface& surface);
  Spread operator()(std::span<const SpreadSource> sources) const;

 private:
  const Surface& surface_;
  std::vector<double> lengths_;  // of the edges, in the order of Surface::adjacency
  double mean_ = 0, longest_ = 0;
};

/// Runs one EdgeSearch.
Spread spread_along_edges(const Surface& surface, std::span<const SpreadSource> sources);

/// Computes straight distances to the nearest source, whose vector is transported in one rotation.
Spread spread_through_space(const Surface& surface, std::span<const SpreadSource> sources);

// Distances along the surface around a point, for brushes.

struct VertexDistance {
  std::uint32_t vertex = 0;
  double distance = 0;  // sizes
};

/// Returns the vertices at most `radius` from the point along the surface, sorted. Uses fast marching that unfolds each
/// triangle about a virtual source (Novotni and Klein 2002): exact on flat parts, and never longer than the path along
/// edges. It marches one ring of vertices beyond the radius, and back from there. The cost depends on the number found,
/// not on the mesh.
std::vector<VertexDistance> distances_within(const Surface& surface, const SurfacePoint& centre, double radius);

/// Returns the distance from the source to a corner of a triangle across the opposite edge, after unfolding. The edge
/// has the length `along`. The corner is `near` and `far` away from the ends of the edge, which are `near_distance` and
/// `far_distance` away from the source. Infinite if the straight path does not cross the edge.
double unfolded_distance(double along, double near, double far, double near_distance, double far_distance);

// Distances along the surface by the heat method.

/// The heat method (Crane et al. 2013) with cotangent weights: heat diffuses from the sources for a short time, and the
/// distance is the function whose gradient best fits the normalized negative gradient of the heat. It converges to the
/// distance along the surface as the mesh gets finer; about 1 % off on meshes of even triangles. The constructor
/// factorizes two matrices (Eigen's sparse Cholesky), after which each set of sources is quick. Degenerate triangles
/// conduct nothing.
class HeatDistance {
 public:
  explicit HeatDistance(const Surface& surface);
  ~HeatDistance();

  /// Returns the distance of each vertex, in sizes; infinite on connected parts without a source. Distances of the
  /// sources themselves are respected.
  std::vector<double> operator()(std::span<const SpreadSource> sources) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
