// Where skin is bare, without GL. renderer/shaders/bare_skin.glsl has the same shapes.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// How bare a region makes the skin at a place with a unit normal: 1 inside its ellipsoid, smoothly down to 0 at
/// 1 + softness of its radii; times its share of the facing. In [0, 1] for every finite place.
double bare_share(const FurSkinRegion& region, glm::dvec3 place, glm::dvec3 normal);

/// Factor on the length of fur that all regions leave, in whatever order: [0, 1], 1 without regions.
double fur_share(std::span<const FurSkinRegion> regions, glm::dvec3 place, glm::dvec3 normal);

}  // namespace pelage
