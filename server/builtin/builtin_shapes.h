// What the built-in models share.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/surface/raw_model.h"

namespace pelage {

/// A model of triangles alone.
RawModel triangle_model(std::vector<glm::dvec3> positions, const std::vector<glm::uvec3>& triangles);

// Each makes about `triangles` triangles, or as few as still make the shape.
RawModel make_torus(int triangles);   // a ring that stands and faces +Z
RawModel make_knot(int triangles);    // a tube along a trefoil that faces +Z
RawModel make_sphere(int triangles);  // radius 1
RawModel make_plane(int triangles);   // 1 x 1 on the ground, upper side out
RawModel make_cloth(int triangles);   // a draped sheet, upper side out
RawModel make_creature(int triangles);

}  // namespace pelage
