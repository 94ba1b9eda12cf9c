// Converts the values that a tool computes into a FieldDelta.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <numeric>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/parallel.h"
#include "server/fields/field_set.h"

namespace pelage {

/// Takes new values of one field, vertex by vertex in rising order, and records those that differ.
class FieldWriter {
 public:
  FieldWriter(const FieldSet& fields, Field field)
      : fields_(fields), part_{field, {}, {}, visible_sheet, fields.owner(field)} {}

  /// Puts a value, rounded and clamped to the field's range. Returns true if it was out of range; always false for
  /// directions, because tools may ask for an inclination beyond 1.
  bool put(std::uint32_t vertex, glm::dvec4 value);
  bool put(std::uint32_t vertex, double value) { return put(vertex, glm::dvec4(value, 0, 0, 0)); }
  bool put(std::uint32_t vertex, glm::dvec2 value) { return put(vertex, glm::dvec4(value, 0, 0)); }

  /// Reserves memory for the changes of this number of vertices.
  void reserve(std::size_t vertices);

  /// Adds the change to the delta. Writers of one command must finish in the order of their fields.
  void finish(FieldDelta& delta);
  /// Adds the changes of several writers of one field as one part; their vertices must follow one another.
  static void finish_together(std::span<FieldWriter> writers, FieldDelta& delta);

 private:
  const FieldSet& fields_;
  FieldDelta::Part part_;
};

/// Writes one field on all cores: calls put(i, writer) once for each i < count, which may put a value for the i-th of
/// rising vertices. Returns how many calls returned true (a value was clamped). Deterministic at any number of threads.
template <class Put>
std::size_t write_in_parallel(const FieldSet& fields, Field field, std::uint32_t count, FieldDelta& delta,
                              const Put& put) {
  constexpr std::uint32_t run = 1 << 14;
  std::vector<FieldWriter> writers((count + run - 1) / run, FieldWriter(fields, field));
  std::vector<std::size_t> clamped(writers.size(), 0);
  for_each_in_parallel(static_cast<std::uint32_t>(writers.size()), [&](std::uint32_t r) {
    const std::uint32_t end = std::min(count, (r + 1) * run);
    writers[r].reserve(end - r * run);
    for (std::uint32_t i = r * run; i < end; ++i) clamped[r] += put(i, writers[r]);
  });
  FieldWriter::finish_together(writers, delta);
  return std::accumulate(clamped.begin(), clamped.end(), std::size_t{0});
}

/// Values of one field that a tool accesses repeatedly while it is evaluated, in double. The cost depends on the number
/// of accessed vertices, not on the mesh.
class WorkingField {
 public:
  WorkingField(const FieldSet& fields, Field field) : fields_(fields), field_(field) {}

  /// Returns the present value of a vertex for reading and writing; the reference is valid until the next call.
  glm::dvec4& at(std::uint32_t vertex);

  /// Adds the change since construction to the delta, rounded once. Returns how many values were clamped.
  std::size_t finish(FieldDelta& delta) const;

 private:
  const FieldSet& fields_;
  Field field_;
  std::unordered_map<std::uint32_t, glm::dvec4> touched_;
};

}  // namespace pelage
