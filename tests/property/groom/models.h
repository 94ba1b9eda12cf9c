// Random models: built-ins of random sizes and dents, a lone triangle, soups and bodies in many parts.
#pragma once

#include "base/random.h"
#include "server/surface/mesh.h"
#include "server/surface/surface.h"

namespace pelage::testing_models {

/// A built-in of random kind and size whose vertices are moved by up to 1 % of its size, so that no two ways on it are
/// equally long. Closed, but for the plane.
RawModel dented_builtin(Random& random);
RawModel lone_triangle(Random& random);
/// Triangles that share nothing, 1 to 30.
RawModel soup(Random& random);
/// Spheres of random places and sizes, 2 to 4.
RawModel many_parts(Random& random);
/// Any of the above.
RawModel any_model(Random& random);

/// Ready for grooming.
Surface surface_of(const RawModel& raw);

}  // namespace pelage::testing_models
