// Makes the built-in models: torus, knot, sphere, plane, cloth, creature.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns a model that has triangles and nothing else.
RawModel triangle_model(std::vector<glm::dvec3> positions, const std::vector<glm::uvec3>& triangles);

// Each makes about `triangles` triangles, but not fewer than the shape needs.
RawModel make_torus(int triangles);   // a ring that stands and faces +Z
RawModel make_knot(int triangles);    // a tube along a trefoil that faces +Z
RawModel make_sphere(int triangles);  // radius 1
RawModel make_plane(int triangles);   // 1 x 1 on the ground, upper side out
RawModel make_cloth(int triangles);   // a draped sheet, upper side out
RawModel make_creature(int triangles);

// The built-in models.

/// Makes a built-in with about `model.triangles` triangles (within a fifth if the shape allows it). Closed shapes have
/// a minimum: sphere 4, torus 18, knot 144, creature 400. Y up, facing +Z, wound counter-clockwise seen from outside
/// (the plane and the cloth from above), no position repeated. The creature has vertex colours and, for each vertex, a
/// length scale of the first groom. Deterministic.
RawModel make_builtin(const BuiltinModel& model);

}  // namespace pelage
