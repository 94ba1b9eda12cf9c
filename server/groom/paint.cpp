#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Composites paint over paint: returns the mean of both colours, weighted by their visible coverage, and the coverage.
glm::dvec4 over(glm::dvec4 below, glm::dvec3 colour, double cover, double weight) {
  const double left = below.w * (1 - weight), applied = cover * weight, both = left + applied;
  const glm::dvec3 mixed = both > 0 ? (left * glm::dvec3(below) + applied * colour) / both : glm::dvec3(0);
  return glm::dvec4(mixed, both);
}

}  // namespace

// Paints a value or a colour; inverted, it restores the field's default.
Evaluation run(const Paint& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const FieldShape& shape = shape_of(command.field);
  const double value = command.brush.invert ? double{shape.default_value} : command.value;
  const Masked masked = command.field == Field::mask ? Masked::no : Masked::yes;
  const double share = strand_share(command.brush, command.field);
  FieldWriter writer(fields, command.field);
  for (const auto [v, reach] : region_of(command.stroke, command.brush, surface, fields, extras, masked)) {
    const double weight = share * reach;
    const glm::dvec4 now(fields.value(command.field, v));
    writer.put(v, shape.channels == 4 ? over(now, glm::dvec3(command.colour), value, weight)
                                      : glm::dvec4(now.x + weight * (value - now.x), 0, 0, 0));
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
