// The built-in models (torus, knot, sphere, plane, cloth, creature), and how each is made by its name.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

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

// The built-in models.

/// Makes a built-in with about `model.triangles` triangles (within a fifth where the shape allows it). Closed shapes
/// have a fewest count of their own: sphere 4, torus 18, knot 144, creature 400. Y up, facing +Z, wound
/// counter-clockwise seen from outside (the plane and the cloth from above), no position repeated. The creature carries
/// vertex colours and a first groom's length for each vertex. Deterministic.
RawModel make_builtin(const BuiltinModel& model);

}  // namespace pelage
