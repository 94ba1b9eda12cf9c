#include "server/surface/triangle_distance.h"

#include <algorithm>

namespace pelage {

namespace {

TrianglePoint at(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place, glm::dvec3 barycentric) {
  const glm::dvec3 point = barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2];
  return {barycentric, glm::length(place - point)};
}

/// Nearest on the side from corner `from` to corner `to`.
TrianglePoint nearest_on_side(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place, int from, int to) {
  const glm::dvec3 start = corners[static_cast<std::size_t>(from)];
  const glm::dvec3 side = corners[static_cast<std::size_t>(to)] - start;
  const double squared = glm::dot(side, side);
  const double t = squared > 0 ? std::clamp(glm::dot(place - start, side) / squared, 0.0, 1.0) : 0.0;
  glm::dvec3 barycentric(0);
  barycentric[from] = 1 - t;
  barycentric[to] = t;
  return at(corners, place, barycentric);
}

}  // namespace

TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place) {
  const glm::dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], p = place - corners[0];
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double squared = glm::dot(normal, normal);
  if (squared > 0) {
    const double v = glm::dot(glm::cross(p, e2), normal) / squared;
    const double w = glm::dot(glm::cross(e1, p), normal) / squared;
    if (v >= 0 && w >= 0 && v + w <= 1) return at(corners, place, {1 - v - w, v, w});
  }
  TrianglePoint best = nearest_on_side(corners, place, 0, 1);
  for (const auto& [from, to] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const TrianglePoint other = nearest_on_side(corners, place, from, to);
    if (other.distance < best.distance) best = other;
  }
  return best;
}

}  // namespace pelage
