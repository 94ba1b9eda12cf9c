#include <cassert>

#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/maps/draw_map.h"

namespace pelage {

// Blends each value V with the picture's M: (1 - w) V + w M, which is exactly M at full strength.
Evaluation run(const ApplyMap& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  assert(extras.picture != nullptr);
  const Mesh& mesh = surface.mesh();
  const MapEncoding encoding = encoding_of(command.field, command.encoding);
  const bool is_length = command.field == Field::length || encoding == MapEncoding::vector;
  const double scale = is_length ? internal_length(command.scale, command.units, mesh) : command.scale;
  const MapTargets targets = read_map(mesh, *extras.picture, command.field, encoding, scale, command.tile);
  Brush everywhere;
  everywhere.strength = command.strength;
  const Masked masked = command.field == Field::mask ? Masked::no : Masked::yes;
  const std::vector<VertexWeight> region = region_of({}, everywhere, surface, fields, extras, masked);
  Evaluation done;
  for (const Field field : targets.fields) {
    FieldWriter writer(fields, field);
    for (const auto [v, weight] : region) {
      if (!targets.says_nothing.empty() && targets.says_nothing[v]) continue;
      if (field == Field::direction && !targets.keeps_direction.empty() && targets.keeps_direction[v]) continue;
      const glm::dvec4 now = to_summable(field, glm::dvec4(fields.value(field, v)));
      const glm::dvec4 there = to_summable(field, targets.values[static_cast<std::size_t>(field)][v]);
      done.clamped += writer.put(v, from_summable(field, (1 - weight) * now + weight * there));
    }
    writer.finish(done.delta);
  }
  return done;
}

}  // namespace pelage
