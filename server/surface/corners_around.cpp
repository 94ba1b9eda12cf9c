#include "server/surface/corners_around.h"

#include <algorithm>

namespace pelage {

namespace {

/// Whether two ends of an edge, with a place on it, and a third vertex are the corners of a triangle. Three vertices
/// that are neighbours need not be: they may go around a tube.
bool is_triangle(const Surface& surface, glm::uvec2 edge, glm::dvec3 place, std::uint32_t third) {
  constexpr double inside = 0.25;
  const glm::dvec3 within = glm::mix(place, glm::dvec3(surface.mesh().positions[third]), inside);
  const glm::uvec3 found = surface.mesh().triangles[surface.nearest(within).triangle];
  const auto has = [&](std::uint32_t v) { return found.x == v || found.y == v || found.z == v; };
  return has(edge.x) && has(edge.y) && has(third);
}

}  // namespace

std::vector<std::uint32_t> corners_around(const Surface& surface, const SurfacePoint& place) {
  constexpr double on_edge = 1e-6;  // barycentric
  const glm::uvec3 triangle = surface.mesh().triangles[place.triangle];
  std::vector<std::uint32_t> corners{triangle.x, triangle.y, triangle.z}, holders;
  for (int k = 0; k < 3; ++k) {
    if (place.barycentric[k] > on_edge) holders.push_back(triangle[k]);
  }
  if (holders.size() == 1) return holders;
  if (holders.size() != 2) return corners;
  const auto others = surface.neighbours(holders[1]);
  for (const std::uint32_t next : surface.neighbours(holders[0])) {
    if (!std::binary_search(others.begin(), others.end(), next)) continue;
    if (std::find(corners.begin(), corners.end(), next) != corners.end()) continue;
    if (is_triangle(surface, {holders[0], holders[1]}, surface.position(place), next)) corners.push_back(next);
  }
  return corners;
}

}  // namespace pelage
