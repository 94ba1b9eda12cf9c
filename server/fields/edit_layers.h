// The stack of edit layers of a field at a vertex, the visible value that it gives, and commands that change edit
// layers.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/field.h"
#include "server/fields/field_set.h"

namespace pelage {

/// The values of a field at one vertex, in summable form (to_summable): the groom, and what each edit layer adds. The
/// visible value is base + weight times added, edit layer by edit layer, clamped to the range each time.
struct EditLayerStack {
  bool covered = false;  // true if any edit layer adds something, or did before a change
  glm::dvec4 base{0};
  std::array<glm::dvec4, limits::edit_layers> added{};
};

EditLayerStack stack_at(const FieldSet& fields, Field field, std::uint32_t vertex, std::size_t layers);

/// Returns a sum clamped to the field's range.
glm::dvec4 clamped(Field field, glm::dvec4 sum);
/// Returns an edit layer's addition, clamped so that it stays finite however often it is groomed.
glm::dvec4 clamped_addition(Field field, glm::dvec4 added);
glm::dvec4 visible_value(const EditLayerStack& stack, Field field, const std::vector<EditLayer>& layers);

/// Takes one field's stacks, vertex by vertex in rising order, and records the bits that they flip on every sheet.
class StackWriter {
 public:
  /// `sheets` is the number of edit layers before or after the change, whichever is larger.
  StackWriter(const FieldSet& fields, Field field, std::size_t sheets);

  /// `layers` gives the weights with which the visible value is computed.
  void put(std::uint32_t vertex, const EditLayerStack& stack, const std::vector<EditLayer>& layers);
  /// Records a visible value that no edit layer covers.
  void put_visible(std::uint32_t vertex, glm::vec4 value) { put(vertex, visible_sheet, value); }

  /// Adds the parts to the delta; finish_parts has to sort them afterwards.
  void finish(FieldDelta& delta);

 private:
  void put(std::uint32_t vertex, Sheet sheet, glm::vec4 value);

  const FieldSet& fields_;
  Field field_;
  std::vector<FieldDelta::Part> parts_;  // by sheet
};

/// Sorts the parts that writers for several fields have added.
void finish_parts(FieldDelta& delta);

// Commands on edit layers, and changes of the visible values.

/// Refuses (invalid): names that are unknown or taken, more than limits::edit_layers, merging muted edit layers.
Status check(const ChangeEditLayer& command, const std::vector<EditLayer>& layers);

/// Refuses (invalid, "/edit_layer") an edit layer that is missing, is muted, or has so small a weight that it could not
/// store a tool's change of the visible values.
Status check_groomed(const std::string& layer, const std::vector<EditLayer>& layers);

/// Returns the edit layers, from the lowest, after a command, which has been checked.
std::vector<EditLayer> with_change(const std::vector<EditLayer>& layers, const ChangeEditLayer& command);

/// Returns the change of the sheets: the contents of edit layers move, and the visible values are computed anew.
FieldDelta change_edit_layers(const ChangeEditLayer& command, const std::vector<EditLayer>& layers,
                              const FieldSet& fields);

/// Converts a change of the visible values into one that the named edit layer stores ("" for the groom below them all).
/// The edit layer then adds the difference to the values that the tool asked for, as far as the field's range and the
/// edit layers above permit. Without edit layers the change is returned unchanged.
FieldDelta stored_in_edit_layer(const FieldDelta& seen, const std::string& layer, const std::vector<EditLayer>& layers,
                                const FieldSet& fields);

/// Returns the index of the edit layer of this name, which must exist.
std::size_t edit_layer_index(const std::string& layer, const std::vector<EditLayer>& layers);

}  // namespace pelage
