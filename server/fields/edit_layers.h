// The stack of edit layers of a field at a vertex, the value that is seen through it, and commands that change
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

/// The values of a field at one vertex, in summable form (to_summable): the groom, and what each edit layer adds. seen
/// = base + weight times added, edit layer by edit layer, clamped to the range each time.
struct EditLayerStack {
  bool covered = false;  // whether any edit layer adds something, or did
  glm::dvec4 base{0};
  std::array<glm::dvec4, limits::edit_layers> added{};
};

EditLayerStack stack_at(const FieldSet& fields, Field field, std::uint32_t vertex, std::size_t layers);

/// Clamps a sum to the field's range.
glm::dvec4 held(Field field, glm::dvec4 sum);
/// Clamps what an edit layer adds, so that it stays finite however often it is groomed.
glm::dvec4 held_addition(Field field, glm::dvec4 added);
glm::dvec4 seen_through(const EditLayerStack& stack, Field field, const std::vector<EditLayer>& layers);

/// Takes one field's stacks, vertex by vertex in rising order, and records the bits that they flip on every sheet.
class StackWriter {
 public:
  /// `sheets`: how many edit layers there are before or after, whichever are more.
  StackWriter(const FieldSet& fields, Field field, std::size_t sheets);

  /// `layers` are the edit layers that the stack is seen through.
  void put(std::uint32_t vertex, const EditLayerStack& stack, const std::vector<EditLayer>& layers);
  /// A value that no edit layer covers.
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

// How edit layers produce the visible values, and how changes of either are carried out.

/// Refused (invalid): names that are unknown or taken, more than limits::edit_layers, merging what is muted.
Status check(const ChangeEditLayer& command, const std::vector<EditLayer>& layers);

/// Refused (invalid, "/edit_layer"): an edit layer that is not there, is muted, or hardly shows, so that it could not
/// take what a tool does to what is seen.
Status check_groomed(const std::string& layer, const std::vector<EditLayer>& layers);

/// The edit layers, from the lowest, once a command that was checked is carried out.
std::vector<EditLayer> with_change(const std::vector<EditLayer>& layers, const ChangeEditLayer& command);

/// Returns what the command does to the sheets: the contents move, and the visible values are computed anew.
FieldDelta change_edit_layers(const ChangeEditLayer& command, const std::vector<EditLayer>& layers,
                              const FieldSet& fields);

/// Converts a change of the visible values into one that the named edit layer stores ("" for the groom below them all).
/// The edit layer comes to hold what is missing for the values that the tool wanted, as far as the field's range and
/// the edit layers above allow it. Without edit layers the change stays as it is.
FieldDelta stored_in_edit_layer(const FieldDelta& seen, const std::string& layer, const std::vector<EditLayer>& layers,
                                const FieldSet& fields);

/// The number of the edit layer of this name, which is there.
std::size_t number_of(const std::string& layer, const std::vector<EditLayer>& layers);

}  // namespace pelage
