// Symmetries of tools: mirror planes and a rotation.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// A plane: a point of it and its normal, model coordinates; the normal is not zero.
struct Plane {
  glm::dvec3 point{0}, normal{1, 0, 0};
};

/// A tool works on every image of its command under the planes and the rotation, as one undo step.
struct Symmetry {
  std::vector<Plane> planes;  // at most 3; two or more give their combinations
  glm::dvec3 axis_point{0}, axis{0, 1, 0};
  int count = 1;  // number of equal steps of the rotation about the axis, [1, 16]; 1 for none
};

}  // namespace pelage
