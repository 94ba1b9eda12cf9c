// One field at one vertex on all its sheets, and the way from there to what is seen.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/edit_layer.h"
#include "server/fields/field_set.h"

namespace pelage {

/// All numbers add up (to_summable). seen = base + weight times added, layer by layer, each time held in the range.
struct LayerStack {
  bool covered = false;  // whether any layer adds something, or did
  glm::dvec4 base{0};
  std::array<glm::dvec4, limits::edit_layers> added{};
};

LayerStack stack_at(const FieldSet& fields, Field field, std::uint32_t vertex, std::size_t layers);

/// Held in the field's range.
glm::dvec4 held(Field field, glm::dvec4 sum);
/// What a layer adds, held so that it stays finite however often it is groomed.
glm::dvec4 held_addition(Field field, glm::dvec4 added);
glm::dvec4 seen_through(const LayerStack& stack, Field field, const std::vector<EditLayer>& layers);

/// Takes one field's stacks vertex by vertex in rising order, and keeps the bits that they turn over on every sheet.
class StackWriter {
 public:
  /// `sheets`: how many layers there are before or after, whichever are more.
  StackWriter(const FieldSet& fields, Field field, std::size_t sheets);

  /// `layers` are those that the stack is seen through.
  void put(std::uint32_t vertex, const LayerStack& stack, const std::vector<EditLayer>& layers);
  /// A value that no layer covers.
  void put_seen(std::uint32_t vertex, glm::vec4 value) { put(vertex, seen_sheet, value); }

  /// Adds the parts to the delta, which finish_parts puts in order.
  void finish(FieldDelta& delta);

 private:
  void put(std::uint32_t vertex, Sheet sheet, glm::vec4 value);

  const FieldSet& fields_;
  Field field_;
  std::vector<FieldDelta::Part> parts_;  // by sheet
};

/// Puts the parts of writers for several fields in order.
void finish_parts(FieldDelta& delta);

}  // namespace pelage
