#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

// Turns fur to the outward direction from the nearest point of the stroke, rotated about the normal; fur at the middle
// itself stays.
Evaluation run(const Whorl& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const double turn = glm::radians(command.brush.invert ? -command.turn_degrees : command.turn_degrees);
  FieldWriter writer(fields, Field::direction);
  if (!command.stroke->samples.empty()) {
    for (const auto [v, weight] : region_of(command.stroke, command.brush, surface, fields, extras)) {
      if (v % 256 == 0) extras.cancel.check();  // each vertex visits the whole stroke
      const VertexFrame frame = frame_at(mesh, v);
      const glm::dvec3 position(mesh.positions[v]);
      const glm::dvec3 out = safe_unit(position - nearest_on_path(*command.stroke, surface, position));
      const glm::dvec3 towards = std::cos(turn) * out + std::sin(turn) * glm::cross(frame.normal, out);
      writer.put(v, leaned_towards(glm::dvec2(fields.direction()[v]), frame, towards, command.lean, weight));
    }
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
