// Random models: built-ins of random sizes and dents, a lone triangle, triangle soups and models of many parts.
#pragma once

#include "base/random.h"
#include "server/surface/mesh.h"
#include "server/surface/surface.h"

namespace pelage::testing_models {

/// A built-in of random kind and size, whose vertices are moved by up to 1 % of its size so that no two paths on it
/// have the same length. Closed, except for the plane.
RawModel dented_builtin(Random& random);
RawModel lone_triangle(Random& random);
/// 1 to 30 triangles that share no vertices.
RawModel soup(Random& random);
/// 2 to 4 spheres of random positions and sizes.
RawModel many_parts(Random& random);
/// One of the above.
RawModel any_model(Random& random);

/// Prepares the model for grooming.
Surface surface_of(const RawModel& raw);

}  // namespace pelage::testing_models
