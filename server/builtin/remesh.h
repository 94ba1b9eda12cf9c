// A closed triangle mesh that can be edited edge by edge.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "server/builtin/implicit.h"

namespace pelage {

/// Returns the triangle's normal with the length of its area.
inline glm::dvec3 area_vector(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return 0.5 * glm::cross(b - a, c - a); }

/// Half-edges of closed triangle meshes: half-edge h is side h % 3 of triangle h / 3. Every vertex has one fan of
/// triangles, also after edits.
class HalfEdgeMesh {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// `mesh` must be a closed 2-manifold.
  explicit HalfEdgeMesh(const TriangleMesh& mesh);

  std::uint32_t half_edge_count() const { return static_cast<std::uint32_t>(origin_.size()); }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(outgoing_.size()); }
  std::size_t live_triangles() const { return live_triangles_; }
  bool live(std::uint32_t half_edge) const { return origin_[half_edge] != kNone; }
  bool vertex_live(std::uint32_t vertex) const { return outgoing_[vertex] != kNone; }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }
  std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
  std::uint32_t target(std::uint32_t h) const { return origin_[next(h)]; }
  std::uint32_t apex(std::uint32_t h) const { return origin_[previous(h)]; }

  glm::dvec3 position(std::uint32_t vertex) const { return positions_[vertex]; }
  void move(std::uint32_t vertex, glm::dvec3 to) { positions_[vertex] = to; }
  double length(std::uint32_t h) const { return glm::distance(positions_[origin(h)], positions_[target(h)]); }

  /// Calls visit(half-edge) for each half-edge that leaves `vertex`.
  template <class Visit>
  void around(std::uint32_t vertex, Visit visit) const {
    std::uint32_t h = outgoing_[vertex];
    do {
      visit(h);
      h = twin_[previous(h)];
    } while (h != outgoing_[vertex]);
  }
  int valence(std::uint32_t vertex) const;

  /// Splits the edge by a new vertex at `at`, and returns the vertex.
  std::uint32_t split(std::uint32_t h, glm::dvec3 at);

  /// Returns whether merging the edge's ends keeps the mesh a manifold of the same genus.
  bool can_collapse(std::uint32_t h) const;
  /// Returns whether moving the edge's origin to `to` would tilt a triangle around it by more than about 70 degrees or
  /// flatten it. The edge's own two triangles do not count.
  bool folds(std::uint32_t h, glm::dvec3 to) const;
  /// Merges the edge's origin into its target, which moves to `to`. Needs can_collapse.
  void collapse(std::uint32_t h, glm::dvec3 to);

  /// Returns whether the edge's two apexes can be joined instead of its ends.
  bool can_flip(std::uint32_t h) const;
  void flip(std::uint32_t h);

  TriangleMesh compact() const;

 private:
  void glue(std::uint32_t h, std::uint32_t other);
  void find_twins();

  std::vector<glm::dvec3> positions_;
  std::vector<std::uint32_t> origin_;    // of each half-edge; kNone once its triangle is gone
  std::vector<std::uint32_t> twin_;      // of each half-edge
  std::vector<std::uint32_t> outgoing_;  // of each vertex: one half-edge that leaves it; kNone once it is gone
  std::size_t live_triangles_ = 0;
};

}  // namespace pelage
