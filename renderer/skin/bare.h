// The shapes of bare skin on the CPU. renderer/shaders/bare_skin.glsl has the same shapes.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns how bare a region makes the skin at a position with a unit normal: 1 inside its ellipsoid, falling smoothly
/// to 0 at 1 + softness of its radii; times the factor for the facing. In [0, 1] for every finite position.
double bare_share(const FurSkinRegion& region, glm::dvec3 position, glm::dvec3 normal);

/// Returns the factor of all regions on the length of fur, independent of their order: [0, 1], 1 without regions.
double fur_share(std::span<const FurSkinRegion> regions, glm::dvec3 position, glm::dvec3 normal);

}  // namespace pelage
