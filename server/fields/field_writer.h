// Turns the values that a tool computes into a change.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

#include "server/fields/field_set.h"

namespace pelage {

/// Takes new values of one field, vertex by vertex in rising order, and keeps those whose bits differ.
class FieldWriter {
 public:
  FieldWriter(const FieldSet& fields, Field field) : fields_(fields), part_{field, {}, {}} {}

  /// Rounded, and held in the field's range. True when a limit held a value back that was on its way further out;
  /// never for directions, whose inclination may be asked for beyond 1.
  bool put(std::uint32_t vertex, glm::dvec4 value);
  bool put(std::uint32_t vertex, double value) { return put(vertex, glm::dvec4(value, 0, 0, 0)); }
  bool put(std::uint32_t vertex, glm::dvec2 value) { return put(vertex, glm::dvec4(value, 0, 0)); }

  /// Adds the change to the delta. Writers of one command finish in the order of their fields.
  void finish(FieldDelta& delta);

 private:
  const FieldSet& fields_;
  FieldDelta::Part part_;
};

/// Values of one field that a tool visits again and again while it is evaluated, in double. Its cost follows the
/// vertices that were asked for, never the mesh.
class WorkingField {
 public:
  WorkingField(const FieldSet& fields, Field field) : fields_(fields), field_(field) {}

  /// What the vertex holds by now; the reference lasts until the next call.
  glm::dvec4& at(std::uint32_t vertex);

  /// Adds the change since the beginning, rounded once. How many values a limit held back.
  std::size_t finish(FieldDelta& delta) const;

 private:
  const FieldSet& fields_;
  Field field_;
  std::unordered_map<std::uint32_t, glm::dvec4> touched_;
};

}  // namespace pelage
