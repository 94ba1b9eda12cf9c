// Edit layers: changes of a groom that are kept apart, so that they can be weighed, muted and taken away.
#pragma once

#include <optional>
#include <string>

#include "protocol/commands/inputs.h"

namespace pelage {

/// Changes that are kept apart from the groom below them: what is seen is the groom and, edit layer by edit layer,
/// their weight times what they add, held in each field's range. The mask lies outside of all edit layers.
struct EditLayer {
  std::string name = {};  // 1 to 200 bytes; names differ
  double weight = 1;      // [-4, 4]; below 0 the opposite of what was groomed
  bool muted = false;
  bool operator==(const EditLayer&) const = default;
};

/// add: a new edit layer. set: changes the weight, the mute or the name. move: to another place among the edit layers.
/// merge_down: into the edit layer below or, of the lowest, into the groom; neither may be muted. remove: with all it
/// holds.
enum class EditLayerAction { add, set, move, merge_down, remove };
struct ChangeEditLayer {
  static constexpr const char* op = "edit_layer";
  static constexpr Inputs inputs = Inputs::none;
  EditLayerAction action = EditLayerAction::add;
  std::string name = {};              // 1 to 200 bytes
  std::optional<double> weight = {};  // of add and set
  std::optional<bool> muted = {};     // of add and set
  std::string rename = {};            // of set; "" keeps the name
  std::optional<std::string> above =
      {};  // of add and move: the edit layer that it comes to lie on, "" for none; add: on top
};

}  // namespace pelage
