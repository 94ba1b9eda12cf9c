#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

Evaluation run(const Lift& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  FieldWriter writer(fields, Field::direction);
  for (const auto [v, weight] : region_of(command.stroke, command.brush, surface, fields, extras)) {
    const glm::dvec2 direction(fields.direction()[v]);
    const double inclination = glm::length(direction);
    if (inclination < no_heading) continue;
    const double goal = command.brush.invert ? 1 : 0;
    writer.put(v, direction * ((inclination + weight * (goal - inclination)) / inclination));
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
