#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

// Leans fur away from the nearest point of the parting line, most strongly near the line; fur on the line itself stays.
Evaluation run(const Part& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const double sign = command.brush.invert ? -1 : 1;
  FieldWriter writer(fields, Field::direction);
  if (!command.stroke->samples.empty()) {
    for (const auto [v, weight] : region_of(command.stroke, command.brush, surface, fields, extras)) {
      if (v % 256 == 0) extras.cancel.check();  // each vertex visits the whole stroke
      const glm::dvec3 position(mesh.positions[v]);
      const glm::dvec3 away = sign * safe_unit(position - nearest_on_path(*command.stroke, surface, position));
      writer.put(v, leaned_towards(glm::dvec2(fields.direction()[v]), frame_at(mesh, v), away, command.lean, weight));
    }
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
