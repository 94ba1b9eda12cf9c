// Aligns one model with another one.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/tools.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Maps positions of one model to another one: a scale for each axis, and a shift.
struct Laid {
  glm::dvec3 scale{1}, shift{0};

  glm::dvec3 place(glm::dvec3 p) const { return scale * p + shift; }
  glm::dvec3 direction(glm::dvec3 d) const { return uniform() ? d : scale * d; }
  /// Of a plane.
  glm::dvec3 normal(glm::dvec3 n) const { return uniform() ? n : n / scale; }
  bool uniform() const { return scale.x == scale.y && scale.y == scale.z; }
};

/// Aligns the internal coordinates of both models. Along an axis on which a box is flat, the scale is 1.
Laid lay_over(const Mesh& from, const Mesh& to, Alignment how);
/// Aligns the models' own coordinates by their boxes.
Laid lay_models_over(const Mesh& from, const Mesh& to);

}  // namespace pelage
