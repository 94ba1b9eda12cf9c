#include "server/builtin/builtin.h"

#include <cassert>

#include "server/builtin/builtin_shapes.h"

namespace pelage {

RawModel triangle_model(std::vector<glm::dvec3> positions, const std::vector<glm::uvec3>& triangles) {
  RawModel model;
  model.positions = std::move(positions);
  model.face_sizes.assign(triangles.size(), 3);
  model.corners.reserve(3 * triangles.size());
  for (const glm::uvec3& t : triangles) model.corners.insert(model.corners.end(), {t.x, t.y, t.z});
  return model;
}

RawModel make_builtin(const BuiltinModel& model) {
  switch (model.shape) {
    case Builtin::torus: return make_torus(model.triangles);
    case Builtin::knot: return make_knot(model.triangles);
    case Builtin::sphere: return make_sphere(model.triangles);
    case Builtin::plane: return make_plane(model.triangles);
    case Builtin::cloth: return make_cloth(model.triangles);
    case Builtin::creature: return make_creature(model.triangles);
  }
  assert(false);
  return {};
}

}  // namespace pelage
