#include "server/groom/alignment.h"

namespace pelage {

namespace {

/// What the box's extents, in sizes, grow by from one model to the other.
glm::dvec3 box_scale(const Mesh& from, const Mesh& to) {
  constexpr double flat = 1e-9;  // sizes
  const glm::dvec3 before = (from.report.bounds.max - from.report.bounds.min) / from.size;
  const glm::dvec3 after = (to.report.bounds.max - to.report.bounds.min) / to.size;
  glm::dvec3 scale(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (before[axis] > flat && after[axis] > flat) scale[axis] = after[axis] / before[axis];
  }
  return scale;
}

}  // namespace

Laid lay_over(const Mesh& from, const Mesh& to, Alignment how) {
  if (how == Alignment::box) return {box_scale(from, to), glm::dvec3(0)};  // both boxes have their middle at 0
  return {glm::dvec3(from.size / to.size), (from.centre - to.centre) / to.size};
}

Laid lay_models_over(const Mesh& from, const Mesh& to) {
  const glm::dvec3 scale = box_scale(from, to) * (to.size / from.size);
  return {scale, to.centre - scale * from.centre};
}

}  // namespace pelage
