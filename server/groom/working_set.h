// What a command changes while it is evaluated: only the vertices that it touches, in double.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>

#include "server/fields/field_set.h"

namespace pelage {

/// Cost follows the vertices that were asked for, never the mesh.
class WorkingSet {
 public:
  struct Fur {
    glm::dvec2 direction{0};
    double length = 0;
    double stretch = 0;
  };

  explicit WorkingSet(const FieldSet& fields) : fields_(fields) {}

  /// What the vertex holds by now; the reference lasts until the next call for another vertex.
  Fur& at(std::uint32_t vertex);

  /// The change since the beginning, rounded once; vertices whose bits stay are not in it.
  FieldDelta delta() const;

 private:
  const FieldSet& fields_;
  std::unordered_map<std::uint32_t, Fur> touched_;
};

}  // namespace pelage
