#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"

namespace pelage {

// Raises the curl field and turns the heading; inverted, it removes the curl and turns the other way.
Evaluation run(const Curl& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const double goal = command.brush.invert ? 0 : command.amount;
  const double turn = glm::radians(command.turn_degrees) * (command.brush.invert ? -1 : 1);
  FieldWriter directions(fields, Field::direction), curls(fields, Field::curl);
  for (const auto [v, weight] : region_of(command.stroke, command.brush, surface, fields, extras)) {
    const glm::dvec2 direction(fields.direction()[v]);
    const double c = std::cos(turn * weight), s = std::sin(turn * weight);
    directions.put(v, glm::dvec2(c * direction.x - s * direction.y, s * direction.x + c * direction.y));
    curls.put(v, glm::mix(double{fields.number(Field::curl, v)}, goal, weight));
  }
  Evaluation done;
  directions.finish(done.delta), curls.finish(done.delta);
  return done;
}

}  // namespace pelage
