// Closed surfaces as the zero set of blended volumes, and their triangle meshes.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// The convex hull of two balls, compressed by `flatten` (1 or more) along the unit vector `flat_axis` through `a`.
/// Neither ball may contain the other unless both are the same.
struct RoundCone {
  glm::dvec3 a{0}, b{0};
  double radius_a = 1, radius_b = 1;
  glm::dvec3 flat_axis{1, 0, 0};
  double flatten = 1;
};

enum class Blend { add, carve };

/// One step of a sculpture: cones that make one body (a chain of them bends like a limb), added to the sculpture so far
/// or carved out of it, with a fillet about `width` wide (> 0) at the junction.
struct Volume {
  std::vector<RoundCone> cones;  // one or more
  double width = 0.01;
  Blend blend = Blend::add;
  double joint_width = 0.016;  // of the fillets between the cones themselves, > 0
};

/// Signed distance (negative inside) and its gradient, whose length is about 1 near the surface. Both are exact on
/// round volumes; on flattened ones they are exact at the surface and a first-order estimate away from it.
struct DistanceSample {
  double distance = 0;
  glm::dvec3 gradient{0};
};

/// The sculpture that results from the volumes in their order.
class ImplicitSurface {
 public:
  /// The first volume must be added, not carved.
  explicit ImplicitSurface(const std::vector<Volume>& volumes);

  DistanceSample sample(glm::dvec3 position) const;

  /// Returns a surface point near `position`, by at most three steps along the gradient, each at most `reach` long.
  glm::dvec3 project(glm::dvec3 position, double reach) const;

  /// The bounding box of all added volumes.
  glm::dvec3 lower() const { return lower_; }
  glm::dvec3 upper() const { return upper_; }

 private:
  struct Ball {
    glm::dvec3 centre{0};
    double radius = 0;
  };
  struct PreparedCone {
    RoundCone cone;
    glm::dvec3 axis{0, 1, 0};     // from a to b, unit, after flattening
    double length = 0;            // |b - a| after flattening
    double sine = 0, cosine = 1;  // of the cone's slope
    Ball hull;
  };
  struct Part {
    std::vector<PreparedCone> cones;
    double width, joint_width;
    Blend blend;
    double max_flat = 1;
    Ball hull;
  };

  static PreparedCone prepare_cone(const RoundCone& cone);
  static Part make_part(const Volume& volume);
  static DistanceSample sample_cone(const PreparedCone& prepared, glm::dvec3 position);
  static DistanceSample sample_part(const Part& part, glm::dvec3 position);
  void extend_box(const Volume& volume);

  std::vector<Part> parts_;
  glm::dvec3 lower_{0}, upper_{0};
};

// Polygonises an implicit surface: closed, even, with about the requested number of triangles.

/// Triangles are wound counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;
};

/// Polygonises by marching tetrahedra on a grid of cubes `cell` wide (> 0). The result is always a closed 2-manifold;
/// its triangles are uneven, its vertices lie within a cell of the surface. Features thinner than two cells may break.
TriangleMesh polygonise(const ImplicitSurface& surface, double cell);

/// Returns the connected part of a closed mesh with the largest number of triangles.
TriangleMesh largest_part(const TriangleMesh& mesh);

/// Remeshes a closed mesh near `surface` to edges of about equal length and about `triangles` triangles (a few hundred
/// or more), and projects the vertices onto the surface. The mesh stays a closed 2-manifold of the same genus.
/// Deterministic.
TriangleMesh remesh(const ImplicitSurface& surface, const TriangleMesh& mesh, int triangles);

/// Collapses edges of a closed mesh in the order of their quadric error until `triangles` are left. Preserves thin
/// features better than remesh, but edges are less even. Stops early if all collapses would fold. Deterministic.
TriangleMesh decimate(const TriangleMesh& mesh, int triangles);

}  // namespace pelage
