// The point of a triangle that is nearest to a place.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace pelage {

struct TrianglePoint {
  glm::dvec3 barycentric{1, 0, 0};  // each in [0, 1], their sum is 1
  double distance = 0;
};

/// Also for triangles that are a line or a point.
TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place);

}  // namespace pelage
