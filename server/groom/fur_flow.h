// The way that fur lies over a whole model before anybody has combed it.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/groom/cancel.h"
#include "server/surface/mesh.h"

namespace pelage {

/// For each vertex a vector in (tangent, bitangent) of its frame: where fur flows, 1 long where the way is clear and
/// shorter towards the few places where it begins, ends or parts. On a body (a part that closes, but for small holes)
/// it follows a potential whose gradient flows out of the chin and into the ends of limbs, ears and tail (poles.h), so
/// that it has no other sources; on sheets, and on bodies with handles, it goes from nose to tail and a little down.
/// Both are then smoothed by the smoothest field that follows them (Knoeppel et al. 2013, "Globally optimal direction
/// fields", eq. 16 with n = 1), in which needless sources cancel: two are left on a ball and none on a torus.
/// Throws Cancelled.
std::vector<glm::dvec2> fur_flow(const Mesh& mesh, const Cancel& cancel = {});

}  // namespace pelage
