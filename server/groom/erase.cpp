#include <algorithm>
#include <cassert>

#include "server/fields/edit_layers.h"
#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Returns whether the field is erased. The mask selects where tools act, so it is erased only if the command names it.
bool erases(const Erase& command, Field field) {
  if (command.fields.empty()) return field != Field::mask;
  return std::count(command.fields.begin(), command.fields.end(), field) > 0;
}

}  // namespace

Evaluation erase_edit_layer(const Erase& command, const Surface& surface, const FieldSet& fields,
                            const std::vector<EditLayer>& layers, const ToolExtras& extras) {
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  const std::size_t layer = edit_layer_index(command.edit_layer, layers);
  Evaluation done;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (!erases(command, field) || fields.untouched(base_sheet, field)) continue;
    const double share = strand_share(command.brush, field);
    StackWriter writer(fields, field, layers.size());
    for (const auto [v, reach] : region) {
      EditLayerStack stack = stack_at(fields, field, v, layers.size());
      if (!stack.covered) continue;
      stack.added[layer] *= 1 - share * reach;
      writer.put(v, stack, layers);
    }
    writer.finish(done.delta);
  }
  finish_parts(done.delta);
  return done;
}

// Blends each value V with the baseline R: (1 - w) V + w R, which is exactly R at full weight.
Evaluation run(const Erase& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  assert(extras.baseline != nullptr && extras.baseline->size() == fields.size());
  const FieldSet& baseline = *extras.baseline;
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  Evaluation done;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (!erases(command, field)) continue;
    if (fields.at_default(field) && baseline.at_default(field)) continue;
    FieldWriter writer(fields, field);
    const double share = strand_share(command.brush, field);
    for (const auto [v, reach] : region) {
      const double weight = share * reach;
      const glm::dvec4 now(fields.value(field, v)), then(baseline.value(field, v));
      writer.put(v, from_summable(field, (1 - weight) * to_summable(field, now) + weight * to_summable(field, then)));
    }
    writer.finish(done.delta);
  }
  return done;
}

}  // namespace pelage
