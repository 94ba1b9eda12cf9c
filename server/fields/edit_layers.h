// How edit layers make what is seen, and what happens to them when what is seen or they themselves are changed.
#pragma once

#include <string>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/edit_layer.h"
#include "server/fields/field_set.h"

namespace pelage {

/// Refused (invalid): names that are unknown or taken, more than limits::edit_layers, merging what is muted.
Status check(const ChangeLayer& command, const std::vector<EditLayer>& layers);

/// Refused (invalid, "/layer"): a layer that is not there, is muted, or hardly shows, so that it could not take what a
/// tool does to what is seen.
Status check_groomed(const std::string& layer, const std::vector<EditLayer>& layers);

/// The layers, from the lowest, once a command that was checked is carried out.
std::vector<EditLayer> with_change(const std::vector<EditLayer>& layers, const ChangeLayer& command);

/// What the command does to the sheets: the contents move, and what is seen is made anew.
FieldDelta change_layers(const ChangeLayer& command, const std::vector<EditLayer>& layers, const FieldSet& fields);

/// A change of what is seen as one that the named layer keeps ("" for the groom below them all): it comes to hold what
/// makes the rest add up to what the tool wanted to be seen, as far as the field's range and the layers above let it.
/// Without layers it is the change itself.
FieldDelta kept_in_layer(const FieldDelta& seen, const std::string& layer, const std::vector<EditLayer>& layers,
                         const FieldSet& fields);

/// The number of the layer of this name, which is there.
std::size_t number_of(const std::string& layer, const std::vector<EditLayer>& layers);

}  // namespace pelage
