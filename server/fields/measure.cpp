#include <algorithm>
#include <cmath>

#include "server/fields/field_set.h"

namespace pelage {

namespace {

/// Gathers the changes of one field over the vertices of a delta.
template <class Distance>
FieldChange measure_field(const char* name, const FieldDelta& delta, const Distance& distance) {
  FieldChange change{.field = name};
  double sum = 0;
  for (std::size_t i = 0; i < delta.vertices.size(); ++i) {
    const double moved = distance(delta.before[i], delta.after[i]);
    if (moved == 0) continue;
    ++change.changed;
    sum += moved;
    change.max_change = std::max(change.max_change, moved);
  }
  if (change.changed > 0) change.mean_change = sum / static_cast<double>(change.changed);
  return change;
}

double moved_by(float a, float b) { return std::abs(double{b} - double{a}); }

}  // namespace

std::vector<FieldChange> measure(const FieldDelta& delta) {
  std::vector<FieldChange> changes;
  const auto keep = [&changes](FieldChange change) {
    if (change.changed > 0) changes.push_back(std::move(change));
  };
  keep(measure_field("direction", delta, [](const Groom& a, const Groom& b) {
    return glm::distance(glm::dvec2(a.direction), glm::dvec2(b.direction));
  }));
  keep(measure_field("length", delta, [](const Groom& a, const Groom& b) { return moved_by(a.length, b.length); }));
  keep(measure_field("stretch", delta, [](const Groom& a, const Groom& b) { return moved_by(a.stretch, b.stretch); }));
  return changes;
}

}  // namespace pelage
