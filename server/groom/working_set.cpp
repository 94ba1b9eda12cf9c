#include "server/groom/working_set.h"

#include <algorithm>
#include <vector>

namespace pelage {

WorkingSet::Fur& WorkingSet::at(std::uint32_t vertex) {
  const auto [place, added] = touched_.try_emplace(vertex);
  if (added) {
    const Groom groom = fields_.at(vertex);
    place->second = {glm::dvec2(groom.direction), groom.length, groom.stretch};
  }
  return place->second;
}

FieldDelta WorkingSet::delta() const {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(touched_.size());
  for (const auto& [vertex, fur] : touched_) vertices.push_back(vertex);
  std::sort(vertices.begin(), vertices.end());
  FieldDelta delta;
  for (const std::uint32_t v : vertices) {
    const Fur& fur = touched_.at(v);
    const Groom before = fields_.at(v), after = stored_groom(fur.direction, fur.length, fur.stretch);
    if (before == after) continue;
    delta.vertices.push_back(v);
    delta.before.push_back(before);
    delta.after.push_back(after);
  }
  return delta;
}

}  // namespace pelage
