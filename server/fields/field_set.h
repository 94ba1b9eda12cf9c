// All fields of a model's coats with their edit layers, the rounding of stored values, and the difference between two
// sets.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "protocol/commands/answers.h"
#include "protocol/commands/field.h"
#include "protocol/commands/scene.h"
#include "server/fields/field_delta.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns a field's value in a form that can be summed. A colour is multiplied by its coverage, so that it does not
/// count at a coverage of 0; other fields are unchanged.
inline glm::dvec4 to_summable(Field field, glm::dvec4 value) {
  return shape_of(field).channels == 4 ? glm::dvec4(glm::dvec3(value) * value.w, value.w) : value;
}

/// Converts a summable value back to a field's value. A colour with a coverage of 0 becomes black.
inline glm::dvec4 from_summable(Field field, glm::dvec4 sum) {
  if (shape_of(field).channels != 4) return sum;
  return sum.w > 0 ? glm::dvec4(glm::dvec3(sum) / sum.w, sum.w) : glm::dvec4(0);
}

// The fields on a surface's vertices, and their hash.

/// The shape of the fur at one vertex.
struct Groom {
  glm::vec2 direction{0};  // in the vertex's (tangent, bitangent); length is the inclination, [0, 1]
  float length = 0;        // sizes, >= 0
  float stretch = 0;       // stretch that the attract tool has built up, >= 0
  bool operator==(const Groom&) const = default;
};

/// Returns the nearest direction that can be stored: not longer than 1 after rounding, and 0 in place of -0.
glm::vec2 stored_direction(glm::dvec2 direction);
/// Returns the nearest value that a channel of any other field can store: in the field's range, and 0 in place of -0.
/// `value` must not be NaN.
float stored_value(Field field, double value);
Groom stored_groom(glm::dvec2 direction, double length, double stretch);

/// The fields of all coats, one of which is selected for access. Copies share arrays until one copy changes them.
class FieldSet {
 public:
  /// Sets all fields to their defaults: fur upright and of length 0. Selects coat 0.
  explicit FieldSet(std::size_t vertices);
  FieldSet(const FieldSet&);
  FieldSet(FieldSet&&) noexcept;
  FieldSet& operator=(const FieldSet&);
  FieldSet& operator=(FieldSet&&) noexcept;
  ~FieldSet();

  /// Returns the selected coat, whose fields are read and set. Fields that all coats share do not depend on it.
  CoatId coat() const { return coat_; }
  void select(CoatId coat);
  FieldSet of_coat(CoatId coat) const;
  /// Returns one more than the largest id of a coat that may have values; holds() tells which coats do.
  std::size_t coats() const { return coats_.size(); }
  /// Returns whether any field of the coat has been touched; always true for coat 0.
  bool holds(CoatId coat) const;
  /// Returns the coat whose array stores a field of the selected coat.
  CoatId owner(Field field) const { return is_shared(field) ? CoatId{0} : coat_; }

  std::size_t size() const { return vertices_; }
  /// Returns the channels at one vertex; 0 beyond the field's own channels.
  glm::vec4 value(Field field, std::uint32_t vertex) const;
  /// Returns the value at one vertex of a field with one channel.
  float number(Field field, std::uint32_t vertex) const;
  Groom at(std::uint32_t vertex) const;

  /// Returns what a sheet holds at one vertex. Where no edit layer adds anything, base_sheet holds NaN, because the
  /// visible value is the groom itself; edit layers hold 0.
  glm::vec4 on_sheet(Sheet sheet, Field field, std::uint32_t vertex) const;
  /// Returns whether no vertex of the field has anything on the sheet.
  bool untouched(Sheet sheet, Field field) const;

  /// Returns all values, channel by channel for each vertex; empty while nothing has touched the field, and after a
  /// delta that has reset all of it.
  const std::vector<float>& values(Field field) const { return array(visible_sheet, field, owner(field)); }
  bool at_default(Field field) const { return values(field).empty(); }
  std::span<const glm::vec2> direction() const;
  std::span<const glm::vec4> colours(Field field) const;  // for a field with four channels; empty if values() is
  const std::vector<float>& length() const { return values(Field::length); }

  /// Returns the value that a part of a delta changes at one vertex, whichever coat is selected.
  glm::vec4 value_of(const FieldDelta::Part& part, std::uint32_t vertex) const;

  /// Returns the hash of all coats. It is updated with each changed vertex. Values at their default add nothing.
  FieldsHash hash() const { return hash_; }
  /// Returns the hash after a delta, without applying it.
  FieldsHash hash_after(const FieldDelta& delta) const;

  /// Returns whether all vertices of the delta exist, as apply requires.
  bool accepts(const FieldDelta& delta) const;
  void apply(const FieldDelta& delta);
  void set(Field field, std::uint32_t vertex, glm::vec4 value);
  void set(std::uint32_t vertex, const Groom& groom);

  /// Returns the size of the arrays in bytes.
  std::size_t bytes() const;

 private:
  /// An array that copies of the set may share; null for defaults.
  using Array = std::shared_ptr<std::vector<float>>;
  using Sheets = std::vector<std::array<Array, field_count>>;  // as many as were ever needed

  const std::vector<float>& array(Sheet sheet, Field field, CoatId coat) const;
  std::vector<float>& touched(Sheet sheet, Field field, CoatId coat);
  glm::vec4 read(Sheet sheet, Field field, CoatId coat, std::uint32_t vertex) const;

  std::size_t vertices_;
  Array upright_, bald_;  // direction and length of an untouched coat, for reading as spans
  CoatId coat_ = 0;
  std::vector<Sheets> coats_;  // as many as were ever needed
  FieldsHash hash_;
};

/// Returns the change between two sets of fields on the same vertices, in all coats.
FieldDelta difference(const FieldSet& from, const FieldSet& to);

/// Measures a change: for each changed field, the number of changed vertices and by how much they change, over all
/// coats. The change of a field with several channels is the length of the difference. `fields` are those before the
/// change or after it.
std::vector<FieldChange> measure(const FieldDelta& delta, const FieldSet& fields);

}  // namespace pelage
