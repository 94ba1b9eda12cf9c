// Where shells of long, leaning fur turn over, and how far fur may lean so that none does (science.md 1). Pure; what it
// is given are plain views in internal coordinates, and lengths are in sizes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

/// A surface and the fur on it. All arrays but `triangles` have one entry for each vertex. `triangles` may be a part of
/// the surface, such as those around the vertices that a stroke touched; their vertices are indices into the arrays.
struct FurredSurface {
  std::span<const glm::vec3> positions, normals, tangents;  // the last two unit and orthogonal
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec2> direction;  // in (tangent, bitangent); its length is the inclination, [0, 1]
  std::span<const float> length;         // >= 0
  LeanCurve curve = LeanCurve::arc;
  double root_share = 0;  // [0, 1]
};

/// The lowest height in (0, 1] at which the shell over each triangle has turned over, of the eight heights that are
/// looked at; 2 where it has not. A shell is the triangle with each corner moved along its strand. Seen in the plane of
/// the triangle that is a linear map J = I + grad(shift); the shell turns over where an eigenvalue of J falls to 0.
/// That is where its determinant does, and it stays so where both fall below, so that the determinant is above 0 again.
/// Triangles without an area never turn over.
std::vector<double> fold_heights(const FurredSurface& surface);

/// How many triangles turn over at some height.
std::size_t count_folds(const FurredSurface& surface);

/// A factor in [0, 1] on the inclination for each vertex, 1 where nothing folds: with it the shell over each triangle
/// keeps a tenth of its width at all heights that are looked at. Only vertices of triangles that would not are changed.
/// Where upright fur folds as well, in a hollow narrower than the fur is long, leaning less is no help, and the
/// triangle is left as it is; `count_folds` then still counts it. Does not depend on the order of the triangles.
std::vector<float> fold_limits(const FurredSurface& surface);

}  // namespace pelage
