// The local frame of a vertex, and rotation of fur directions in it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "server/surface/mesh.h"

namespace pelage {

/// An orthonormal frame, internal coordinates. Frames of neighbours differ, so a direction in space is projected on
/// each.
struct VertexFrame {
  glm::dvec3 normal, tangent, bitangent;

  glm::dvec2 tangent_part(glm::dvec3 v) const { return {glm::dot(v, tangent), glm::dot(v, bitangent)}; }
};

inline VertexFrame frame_at(const Mesh& mesh, std::uint32_t vertex) {
  const glm::dvec3 normal(mesh.normals[vertex]), tangent(mesh.tangents[vertex]);
  return {normal, tangent, glm::cross(normal, tangent)};
}

/// Tangent parts of unit vectors that are shorter than this have no usable heading.
inline constexpr double no_heading = 1e-6;

/// Returns V + weight (lean t - V) for the direction V, where t is the normalized tangent part of the unit vector
/// `towards`; returns V if that has no heading.
inline glm::dvec2 leaned_towards(glm::dvec2 direction, const VertexFrame& frame, glm::dvec3 towards, double lean,
                                 double weight) {
  const glm::dvec2 part = frame.tangent_part(towards);
  const double along = glm::length(part);
  if (along < no_heading) return direction;
  return direction + weight * (lean * part / along - direction);
}

/// Returns the unit vector along a finite vector, even where its square is out of range of double; 0 for 0.
inline glm::dvec3 safe_unit(glm::dvec3 v) {
  const double largest = glm::max(glm::max(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
  return largest > 0 ? glm::normalize(v / largest) : glm::dvec3(0);
}

}  // namespace pelage
