#include <algorithm>
#include <cassert>

#include "server/fields/field_writer.h"
#include "server/groom/region.h"
#include "server/groom/tools.h"

namespace pelage {

// (1 - w) V + w R: at full strength exactly what was.
Evaluation erase(const Erase& command, const Surface& surface, const FieldSet& fields, const FieldSet& rest) {
  assert(rest.size() == fields.size());
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields);
  Evaluation done;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    const bool named = std::count(command.fields.begin(), command.fields.end(), field) > 0;
    // The mask chooses where tools work; it is not what they undo unless it is asked for.
    if (!named && (!command.fields.empty() || field == Field::mask)) continue;
    if (fields.at_rest(field) && rest.at_rest(field)) continue;
    FieldWriter writer(fields, field);
    for (const auto [v, weight] : region)
      writer.put(v, (1 - weight) * glm::dvec4(fields.value(field, v)) + weight * glm::dvec4(rest.value(field, v)));
    writer.finish(done.delta);
  }
  return done;
}

}  // namespace pelage
