// Distances over a surface from sources (edge search, through space, heat method), with directions carried along,
// and the priority queue of the searches.
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

/// Gives vertices by rising distance, and of equally far ones by rising number: the order of a binary heap. It relies
/// on nothing being added nearer than what was taken last, or much farther. Distances lie in bands; those of later
/// bands wait unsorted (Dial 1969), so that the heap of the present band stays small.
class MonotoneQueue {
 public:
  using Place = std::pair<double, std::uint32_t>;

  /// Bands are `width` wide, above 0. What is added lies at most `reach` beyond what was taken last, but for the first.
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

  /// The least distance in it; infinite when it is empty.
  double min() {
    if (empty()) return std::numeric_limits<double>::infinity();
    while (near_.empty()) {
      near_.swap(bands_[++band_ % bands_.size()]);
      std::make_heap(near_.begin(), near_.end(), std::greater<>());
    }
    return near_.front().first;
  }

  /// Takes the nearest out. There must be one.
  Place pop() {
    min();
    std::pop_heap(near_.begin(), near_.end(), std::greater<>());
    const Place place = near_.back();
    near_.pop_back();
    --count_;
    return place;
  }

 private:
  double width_;
  std::vector<std::vector<Place>> bands_;  // by their number modulo their count
  std::vector<Place> near_;                // a heap of the band `band_` and those before it
  std::uint64_t band_ = 0;
  std::size_t count_ = 0;
};

// Bringing a direction in the surface from one vertex to another.

/// The tangent vector `v` of the plane across unit `from`, turned by the smallest rotation that takes `from` to unit
/// `to`. Dropping the normal part instead is 49 degrees off where the rotation is 1.7 (science.md 3). For such a vector
/// that rotation is the reflection by the plane across from + to, which keeps its length however near to
/// opposite the normals are and however they are rounded; v - (to.v) / (1 + d) (from + to) does not. Between opposite
/// normals no rotation is smallest: `v`, which lies in both planes, stays.
inline glm::dvec3 transported(glm::dvec3 v, glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 both = from + to;
  const double square = glm::dot(both, both);  // 2 (1 + d)
  constexpr double opposite = 2e-9;
  if (square < opposite) return v;
  return v - 2 * glm::dot(both, v) / square * both;
}

// The corners that a place on the surface lies between.

/// The vertices that a place lies between: the corners of the triangle that holds it, of all such triangles on an edge,
/// and at a vertex that one alone. Queries name any triangle that holds a place; what starts here does not depend on
/// which.
std::vector<std::uint32_t> corners_around(const Surface& surface, const SurfacePoint& place);

// Distances over the whole surface from a set of sources, and directions brought along the way.

/// A place that distances count from.
struct SpreadSource {
  std::uint32_t vertex = 0;
  double distance = 0;   // of the vertex itself from the source
  glm::dvec3 vector{0};  // in the vertex's tangent plane
};

struct Spread {
  std::vector<double> distance;    // for each vertex, sizes; infinite where no path leads
  std::vector<glm::dvec3> vector;  // the nearest source's, carried there by smallest rotations along the path
};

/// Dijkstra along edges (fur modelling 5.1). Overestimates the distance along the surface, and subdividing the mesh
/// does not cure that. Lengths of edges are found once for all searches, which may run in parallel. Of several shortest
/// paths to a vertex, the one whose last step begins nearest to its source counts, and of those the one from the lowest
/// vertex.
class EdgeSearch {
 public:
  explicit EdgeSearch(const Surface& surface);
  Spread operator()(std::span<const SpreadSource> sources) const;

 private:
  const Surface& surface_;
  std::vector<double> lengths_;  // of the edges in the order of Surface::adjacency
  double mean_ = 0, longest_ = 0;
};

/// One search.
Spread spread_along_edges(const Surface& surface, std::span<const SpreadSource> sources);

/// Computes distances through space to the nearest source; its vector is carried in one rotation.
Spread spread_through_space(const Surface& surface, std::span<const SpreadSource> sources);

// Distances along the surface around a point, for brushes.

struct VertexDistance {
  std::uint32_t vertex = 0;
  double distance = 0;  // sizes
};

/// Vertices at most `radius` from the point along the surface, rising. Fast marching that unfolds each triangle about
/// a virtual source (Novotni and Klein 2002): exact on flat parts, and never longer than the way along edges. It
/// marches one ring of vertices beyond the radius, and back from there. Cost follows the number found, not the mesh.
std::vector<VertexDistance> distances_within(const Surface& surface, const SurfacePoint& centre, double radius);

/// Returns the distance from the source to a corner of a triangle whose other corners are `along` apart. It is `near`
/// and `far` away from them, and they are `near_distance` and `far_distance` away from the source. Infinite where the
/// straight path does not pass between them.
double unfolded_distance(double along, double near, double far, double near_distance, double far_distance);

// Distances along the surface by the heat method.

/// The heat method (Crane et al. 2013) with cotangent weights: heat flows from the sources for a short while, and the
/// distance is the function whose gradient best points away along it. It converges to the distance along the surface
/// as the mesh gets finer; about 1 % off on meshes of even triangles. Factorises two matrices when it is made (Eigen's
/// sparse Cholesky), after which each set of sources is quick. Degenerate triangles conduct nothing.
class HeatDistance {
 public:
  explicit HeatDistance(const Surface& surface);
  ~HeatDistance();

  /// For each vertex, sizes; infinite on connected parts without a source. The sources' own distances are kept.
  std::vector<double> operator()(std::span<const SpreadSource> sources) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
