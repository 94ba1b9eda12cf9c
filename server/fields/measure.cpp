#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "server/fields/field_set.h"

namespace pelage {

namespace {

FieldChange measure_part(const FieldDelta::Part& part, const FieldSet& fields) {
  const int channels = shape_of(part.field).channels;
  FieldChange change{.field = std::string(shape_of(part.field).name), .changed = part.vertices.size()};
  const std::uint32_t* flips = part.flips.data();
  double sum = 0;
  for (const std::uint32_t v : part.vertices) {
    const glm::vec4 here = fields.value(part.field, v);
    double square = 0;
    for (int c = 0; c < channels; ++c) {
      const double there = std::bit_cast<float>(std::bit_cast<std::uint32_t>(here[c]) ^ flips[c]);
      square += (there - here[c]) * (there - here[c]);
    }
    flips += channels;
    sum += std::sqrt(square);
    change.max_change = std::max(change.max_change, std::sqrt(square));
  }
  change.mean_change = sum / static_cast<double>(part.vertices.size());
  return change;
}

}  // namespace

std::vector<FieldChange> measure(const FieldDelta& delta, const FieldSet& fields) {
  std::vector<FieldChange> changes;
  changes.reserve(delta.parts.size());
  for (const FieldDelta::Part& part : delta.parts) {
    if (part.sheet == seen_sheet) changes.push_back(measure_part(part, fields));
  }
  return changes;
}

}  // namespace pelage
