// The default direction of fur on a whole model, before any grooming.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/groom/cancel.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns for each vertex a vector in (tangent, bitangent) of its frame: the direction in which fur flows, of length 1
/// where it is clear and shorter near the few points where fur begins, ends or parts. On a body (a part that is closed,
/// apart from small holes) it runs down a potential from the chin into the ends of limbs, ears and tail (poles.h), so
/// that it has no other sources. On sheets, and on bodies with handles, it runs from nose to tail and a little down.
/// Both are then replaced by the smoothest field that follows them (Knoeppel et al. 2013, "Globally optimal direction
/// fields", eq. 16 with n = 1), in which unnecessary sources cancel: two remain on a ball and none on a torus. Throws
/// Cancelled.
std::vector<glm::dvec2> fur_flow(const Mesh& mesh, const Cancel& cancel = {});

}  // namespace pelage
