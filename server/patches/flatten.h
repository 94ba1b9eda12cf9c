// Flattens a part of a surface with as little stretch as possible.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/mesh.h"

namespace pelage {

/// A part of a mesh on the plane, in sizes.
struct FlatPatch {
  std::vector<std::uint32_t> vertices;  // of the mesh, rising
  std::vector<glm::uvec3> triangles;    // indices in `vertices`, in the order they were given
  std::vector<glm::dvec2> uv;           // of each of `vertices`
};

/// Flattens triangles: a discrete exponential map around `seed`, one of their vertices (Schmidt et al. 2006, with
/// averaged predictions), then local/global iterations towards rigid triangles (ARAP, Liu et al. 2008), then one scale
/// to preserve the area. Triangles that do not form a surface keep the exponential map. u runs along the mean of the
/// vertices' tangents. Always finite; triangles without area follow their edges. Deterministic.
FlatPatch flatten(const Mesh& mesh, std::span<const std::uint32_t> triangles, std::uint32_t seed);

/// The stretch of the map from a triangle to the plane: its singular values, the larger first.
struct Stretch {
  double large = 1, small = 1;
  bool flipped = false;

  double area() const { return large * small; }
  double angle() const { return large / small; }  // 1 keeps angles
};

/// Returns the stretch of a triangle's map; no stretch if the triangle has no area.
Stretch stretch_of(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec2, 3>& uv);

}  // namespace pelage
