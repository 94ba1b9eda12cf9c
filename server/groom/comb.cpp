#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// Returns a direction turned towards a direction in space, with the command's inclination or each strand's own.
glm::dvec2 combed(const Comb& command, glm::dvec2 direction, const VertexFrame& frame, glm::dvec3 towards,
                  double weight) {
  const double own = glm::length(direction);
  const glm::dvec2 after =
      leaned_towards(direction, frame, towards, command.keep_inclination ? own : command.lean, weight);
  const double length = glm::length(after);
  return command.keep_inclination && length > no_heading ? after * (own / length) : after;
}

/// Combs the whole surface in one direction.
void comb_flood(const Comb& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras,
                FieldDelta& delta) {
  if (!command.direction) return;
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 towards = safe_unit(*command.direction) * (command.brush.invert ? -1.0 : 1.0);
  const std::vector<VertexWeight> region = region_of({}, command.brush, surface, fields, extras);
  const auto count = static_cast<std::uint32_t>(region.size());
  write_in_parallel(fields, Field::direction, count, delta, [&](std::uint32_t i, FieldWriter& writer) {
    const auto [v, weight] = region[i];
    return writer.put(v, combed(command, glm::dvec2(fields.direction()[v]), frame_at(mesh, v), towards, weight));
  });
}

/// Turns fur at each dab in the direction in which the brush moved. The exponent makes many small dabs equivalent to
/// one large dab.
void comb_stroke(const Comb& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras,
                 FieldDelta& delta) {
  const std::optional<StandingFur> fur = fur_reached(command.brush, surface, fields, extras.coat);
  const BrushStroke stroke(*command.stroke, command.brush, surface, fur ? &*fur : nullptr, extras.alpha);
  WorkingField directions(fields, Field::direction);
  std::vector<VertexWeight> weights;
  for (const Dab& dab : stroke.moving_dabs()) {
    const glm::dvec3 towards = command.brush.invert ? -dab.motion : dab.motion;
    extras.cancel.check();
    stroke.weigh(dab, weights);
    for (const auto [vertex, weight] : weights) {
      glm::dvec4& direction = directions.at(vertex);
      const double share = 1 - std::pow(1 - weight * fields.number(Field::mask, vertex), dab.step);
      direction =
          glm::dvec4(combed(command, glm::dvec2(direction), frame_at(surface.mesh(), vertex), towards, share), 0, 0);
    }
  }
  directions.finish(delta);
}

}  // namespace

Evaluation run(const Comb& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  Evaluation done;
  if (command.flood)
    comb_flood(command, surface, fields, extras, done.delta);
  else if (command.stroke)
    comb_stroke(command, surface, fields, extras, done.delta);
  return done;
}

}  // namespace pelage
