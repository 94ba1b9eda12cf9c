// Queries on a mesh: rays, nearest points, vertices in a ball, neighbours.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A place on the surface: position = sum of barycentric[k] * corner k.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
};

/// A mesh with what speeds up questions about it. All coordinates are internal. Const calls may run in parallel.
class Surface {
 public:
  explicit Surface(Mesh mesh);
  ~Surface();
  Surface(Surface&&) noexcept;
  Surface& operator=(Surface&&) noexcept;

  const Mesh& mesh() const;

  /// First hit of the ray from `origin` along `direction` (any length but 0), from either side (Embree, robust mode).
  std::optional<SurfacePoint> raycast(glm::dvec3 origin, glm::dvec3 direction) const;

  /// Nearest point of the surface (Embree point query).
  SurfacePoint nearest(glm::dvec3 position) const;

  /// Vertices at most `radius` from `centre`, in rising order; cost follows the number found and not the mesh.
  void vertices_within(glm::dvec3 centre, double radius, std::vector<std::uint32_t>& found) const;

  /// Vertices that share an edge with `vertex`, in rising order.
  std::span<const std::uint32_t> neighbours(std::uint32_t vertex) const;
  /// All of them.
  const Adjacency& adjacency() const;

  glm::dvec3 position(const SurfacePoint& point) const;
  glm::dvec3 normal(const SurfacePoint& point) const;  // interpolated vertex normals, unit

  /// What the mesh and all beside it take in memory.
  std::size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
