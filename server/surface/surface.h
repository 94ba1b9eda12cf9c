// The surface of a mesh with its queries (ray, nearest position, vertices in a ball or along a line), and the balanced
// k-d tree, stored in one array, behind them. Unlike a uniform grid, the tree is not slowed down by one far vertex.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

class PointTree {
 public:
  explicit PointTree(std::span<const glm::vec3> points);

  /// Appends the points at most `radius` from `centre`, in no particular order; nothing for a negative or NaN radius.
  /// `points` must be those that the tree was built from. Costs O(found + sqrt(points)) on a surface.
  void find_within(std::span<const glm::vec3> points, glm::dvec3 centre, double radius,
                   std::vector<std::uint32_t>& found) const;
  /// Does the same for the points at most `radius` from the segment between two positions.
  void find_along(std::span<const glm::vec3> points, glm::dvec3 from, glm::dvec3 to, double radius,
                  std::vector<std::uint32_t>& found) const;

  /// Returns the bytes of memory that the tree takes.
  std::size_t bytes() const { return order_.capacity() * sizeof(std::uint32_t) + boxes_.capacity() * sizeof(Box); }

 private:
  struct Box {
    glm::vec3 low, high;
  };
  struct Ball;
  struct Capsule;

  void build(std::span<const glm::vec3> points, std::size_t node, std::size_t begin, std::size_t end);
  template <class Shape>
  void search(std::span<const glm::vec3> points, const Shape& shape, std::size_t node, std::size_t begin,
              std::size_t end, std::vector<std::uint32_t>& found) const;

  std::vector<std::uint32_t> order_;  // point indices; a node owns a range of it, its children the two halves
  std::vector<Box> boxes_;            // one for each node; the children of node n are 2n+1 and 2n+2
};

// The nearest point of a triangle.

struct TrianglePoint {
  glm::dvec3 barycentric{1, 0, 0};  // each in [0, 1], with sum 1
  double distance = 0;
};

/// Returns the point of a triangle nearest to a position; triangles degenerated to a line or a point are allowed.
TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, glm::dvec3 position);

// Queries on a mesh: rays, nearest points, vertices in a ball, neighbours.

/// A position on the surface: the sum of barycentric[k] * corner k.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
};

/// A mesh with acceleration structures for queries. All coordinates are internal. Const calls may run in parallel.
class Surface {
 public:
  explicit Surface(Mesh mesh);
  ~Surface();
  Surface(Surface&&) noexcept;
  Surface& operator=(Surface&&) noexcept;

  const Mesh& mesh() const;

  /// Returns the first hit of the ray from `origin` along `direction` (any length but 0), from either side (Embree,
  /// robust mode).
  std::optional<SurfacePoint> raycast(glm::dvec3 origin, glm::dvec3 direction) const;

  /// Returns the nearest point of the surface (Embree point query).
  SurfacePoint nearest(glm::dvec3 position) const;

  /// Finds the vertices at most `radius` from `centre`, sorted. The cost depends on the number found, not on the mesh.
  void vertices_within(glm::dvec3 centre, double radius, std::vector<std::uint32_t>& found) const;
  /// Finds the vertices at most `radius` from the segment between two positions, sorted, at a cost as above.
  void vertices_along(glm::dvec3 from, glm::dvec3 to, double radius, std::vector<std::uint32_t>& found) const;

  /// Returns the vertices that share an edge with `vertex`, sorted.
  std::span<const std::uint32_t> neighbours(std::uint32_t vertex) const;
  /// Returns the neighbours of all vertices.
  const Adjacency& adjacency() const;

  glm::dvec3 position(const SurfacePoint& point) const;
  glm::dvec3 normal(const SurfacePoint& point) const;  // interpolated vertex normals, unit

  /// Returns the bytes of memory that the mesh and the acceleration structures take.
  std::size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
