#include "server/scene/farthest_point.h"

#include <array>
#include <limits>
#include <vector>

namespace pelage {

namespace {

/// A corner of the polygon that the box cuts from a triangle.
struct Corner {
  glm::dvec3 position, barycentric;
};

struct HalfSpace {
  int axis;
  double side, bound;  // inside: side * position[axis] <= side * bound

  double depth(glm::dvec3 position) const { return side * (bound - position[axis]); }
};

/// Clips a convex polygon to a half space (Sutherland and Hodgman 1974). `clipped` is scratch memory.
void clip(std::vector<Corner>& polygon, const HalfSpace& half, std::vector<Corner>& clipped) {
  clipped.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double in_from = half.depth(from.position), in_to = half.depth(to.position);
    if (in_from >= 0) clipped.push_back(from);
    if ((in_from >= 0) == (in_to >= 0)) continue;
    const double share = in_from / (in_from - in_to);
    clipped.push_back({glm::mix(from.position, to.position, share), glm::mix(from.barycentric, to.barycentric, share)});
  }
  polygon.swap(clipped);
}

std::vector<HalfSpace> half_spaces(const Mesh& mesh, const PickFarthest& wanted) {
  if (!wanted.min) return {};
  const glm::dvec3 min = mesh.to_internal(*wanted.min), max = mesh.to_internal(*wanted.max);
  return {{0, -1, min.x}, {1, -1, min.y}, {2, -1, min.z}, {0, 1, max.x}, {1, 1, max.y}, {2, 1, max.z}};
}

}  // namespace

std::optional<SurfacePoint> farthest_point(const Surface& surface, const PickFarthest& wanted) {
  const Mesh& mesh = surface.mesh();
  const std::vector<HalfSpace> box = half_spaces(mesh, wanted);
  const glm::dvec3 direction = glm::normalize(wanted.direction);
  double farthest = -std::numeric_limits<double>::infinity();
  std::optional<SurfacePoint> found;
  std::vector<Corner> polygon, clipped;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    polygon.clear();
    for (int k = 0; k < 3; ++k) {
      glm::dvec3 corner(0);
      corner[k] = 1;
      polygon.push_back({glm::dvec3(mesh.positions[mesh.triangles[t][k]]), corner});
    }
    for (const HalfSpace& half : box) clip(polygon, half, clipped);
    for (const Corner& corner : polygon) {
      const double along = glm::dot(corner.position, direction);
      if (along > farthest) farthest = along, found = SurfacePoint{t, corner.barycentric};
    }
  }
  return found;
}

}  // namespace pelage
