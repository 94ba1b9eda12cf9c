#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// Combs the whole surface one way.
void comb_flood(const Comb& command, const Surface& surface, const FieldSet& fields, FieldDelta& delta) {
  if (!command.direction) return;
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 towards = safe_unit(*command.direction) * (command.brush.invert ? -1.0 : 1.0);
  FieldWriter writer(fields, Field::direction);
  for (const auto [v, weight] : reach({}, command.brush, command.brush.strength, surface, fields)) {
    writer.put(v, turned(glm::dvec2(fields.direction()[v]), frame_at(mesh, v), towards, command.lean, weight));
  }
  writer.finish(delta);
}

/// Each dab turns fur the way that the brush moved. The exponent makes many small dabs do what one large one does.
void comb_stroke(const Comb& command, const Surface& surface, const FieldSet& fields, FieldDelta& delta) {
  const BrushStroke stroke(*command.stroke, command.brush, surface, fields);
  WorkingField directions(fields, Field::direction);
  std::vector<VertexWeight> weights;
  for (const Dab& dab : stroke.moving_dabs()) {
    const glm::dvec3 towards = command.brush.invert ? -dab.motion : dab.motion;
    stroke.weigh(dab, weights);
    for (const auto [vertex, weight] : weights) {
      glm::dvec4& direction = directions.at(vertex);
      direction = glm::dvec4(turned(glm::dvec2(direction), frame_at(surface.mesh(), vertex), towards, command.lean,
                                    1 - std::pow(1 - weight, dab.step)),
                             0, 0);
    }
  }
  directions.finish(delta);
}

}  // namespace

Evaluation comb(const Comb& command, const Surface& surface, const FieldSet& fields) {
  Evaluation done;
  if (command.flood)
    comb_flood(command, surface, fields, done.delta);
  else if (command.stroke)
    comb_stroke(command, surface, fields, done.delta);
  return done;
}

}  // namespace pelage
