// Bringing a direction in the surface from one vertex to another.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

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

}  // namespace pelage
