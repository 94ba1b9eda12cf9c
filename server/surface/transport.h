// Bringing a direction in the surface from one vertex to another.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// The tangent vector `v` of the plane across unit `from`, turned by the smallest rotation that takes `from` to unit
/// `to`. Dropping the normal part instead is 49 degrees off where the rotation is 1.7 (science.md 3). Between opposite
/// normals no rotation is smallest: `v`, which lies in both planes, stays.
inline glm::dvec3 transported(glm::dvec3 v, glm::dvec3 from, glm::dvec3 to) {
  const double cosine = glm::dot(from, to);
  constexpr double opposite = -1 + 1e-9;
  if (cosine < opposite) return v;
  return v - glm::dot(to, v) / (1 + cosine) * (from + to);
}

}  // namespace pelage
