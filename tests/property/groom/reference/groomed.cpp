#include "tests/property/groom/reference/groomed.h"

#include <algorithm>
#include <cmath>

#include "tests/property/groom/reference/tools.h"

namespace pelage::plain {

namespace {

/// Clamps to the field's range, and a direction to length 1.
dvec4 held(Field field, dvec4 value) {
  const FieldShape& shape = shape_of(field);
  if (field == Field::direction) {
    const double longer = std::hypot(value.x, value.y);
    return longer > 1 ? value / longer : value;
  }
  for (int c = 0; c < shape.channels; ++c)
    value[c] = std::min(std::max(value[c], double{shape.min}), double{shape.max});
  return value;
}

}  // namespace

Fur groomed(const Command& command, const Stage& stage, const Fur& before) {
  Fur fur = before;
  std::visit(
      [&](const auto& tool) {
        if constexpr (requires { apply(tool, stage, fur); }) apply(tool, stage, fur);
      },
      command);
  for (std::size_t f = 0; f < field_count; ++f) {
    for (dvec4& value : fur.values[f]) value = held(field_at(f), value);
  }
  return fur;
}

}  // namespace pelage::plain
