// The built-in models.
#pragma once

#include "protocol/commands/scene.h"
#include "server/surface/raw_model.h"

namespace pelage {

/// Makes a built-in with about `model.triangles` triangles (within a fifth where the shape allows it). Closed shapes
/// have a fewest count of their own: sphere 4, torus 18, knot 144, creature 400. Y up, facing +Z, wound
/// counter-clockwise seen from outside (the plane and the cloth from above), no position repeated. The creature carries
/// vertex colours and a first groom's length for each vertex. Deterministic.
RawModel make_builtin(const BuiltinModel& model);

}  // namespace pelage
