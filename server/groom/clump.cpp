#include <algorithm>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

constexpr double min_lean = 0.5;  // upright fur must lean so that its tips can meet

}  // namespace

// Turns fur towards the nearest point of the stroke and raises the field; inverted, it does the opposite.
Evaluation run(const Clump& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const double sign = command.brush.invert ? -1 : 1, goal = command.brush.invert ? 0 : command.amount;
  FieldWriter directions(fields, Field::direction), clumps(fields, Field::clump);
  if (!command.stroke->samples.empty()) {
    for (const auto [v, weight] : region_of(command.stroke, command.brush, surface, fields, extras)) {
      if (v % 256 == 0) extras.cancel.check();  // each vertex visits the whole stroke
      const glm::dvec3 position(mesh.positions[v]);
      const glm::dvec3 middle = sign * safe_unit(nearest_on_path(*command.stroke, surface, position) - position);
      const glm::dvec2 direction(fields.direction()[v]);
      const double lean = std::max(glm::length(direction), min_lean);
      directions.put(v, leaned_towards(direction, frame_at(mesh, v), middle, lean, weight * command.gather));
      clumps.put(v, glm::mix(double{fields.number(Field::clump, v)}, goal, weight));
    }
  }
  Evaluation done;
  directions.finish(done.delta), clumps.finish(done.delta);
  return done;
}

}  // namespace pelage
