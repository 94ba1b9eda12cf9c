// Aligns one model with another, and finds the positions of one that are nearest to the vertices of the other.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/tools.h"
#include "server/fields/field_mix.h"
#include "server/surface/mesh.h"
#include "server/surface/surface.h"

namespace pelage {

/// A map from positions of one model to another: a scale for each axis, then a shift.
struct AlignmentTransform {
  glm::dvec3 scale{1}, shift{0};

  glm::dvec3 mapped(glm::dvec3 p) const { return scale * p + shift; }
  glm::dvec3 direction(glm::dvec3 d) const { return uniform() ? d : scale * d; }
  /// Maps the normal of a plane.
  glm::dvec3 normal(glm::dvec3 n) const { return uniform() ? n : n / scale; }
  bool uniform() const { return scale.x == scale.y && scale.y == scale.z; }
};

/// Returns the map between the internal coordinates of both models. Along an axis on which a box is flat, the scale is
/// 1.
AlignmentTransform internal_alignment(const Mesh& from, const Mesh& to, Alignment how);
/// Returns the map between the models' own coordinates.
AlignmentTransform model_alignment(const Mesh& from, const Mesh& to, Alignment how);

/// The corners of the source triangle nearest to each vertex, the number of vertices that lie farther than
/// far_threshold from it, and the median distance, sizes of the source.
struct NearestCorners {
  std::vector<std::array<MixShare, 3>> corners;
  std::size_t far = 0;
  double median = 0;
};
inline constexpr double far_threshold = 0.05;  // sizes of the source
NearestCorners nearest_corners(const Mesh& mesh, const Surface& source, Alignment align);

/// Returns the factor from a length in sizes of `from` to one in sizes of `to`.
double length_factor(const Mesh& from, const Mesh& to, Alignment how);

}  // namespace pelage
