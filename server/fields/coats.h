// The coats of a scene: how set_coats changes them, and what that does to their fields.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"

namespace pelage {

/// Null where no coat has the name. "" names the first.
const NamedCoat* find_coat(const std::vector<NamedCoat>& coats, const std::string& name);

/// What a summary says of them: all but their strands.
std::vector<CoatEntry> names_of(const std::vector<NamedCoat>& coats);

/// The first that is not muted.
const NamedCoat& first_seen(const std::vector<NamedCoat>& coats);

/// Refused (invalid, "/coats/K/..."): a new coat that begins from one that is not there, `begins` of one that is
/// there, and more than limits::coats.
Status check(const SetCoats& command, const std::vector<NamedCoat>& coats);
/// Refused (invalid, "/name"): a coat that is not there.
Status check(const SetCoat& command, const std::vector<NamedCoat>& coats);

/// The coats once a command that was checked is carried out.
std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoats& command);
std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoat& command);

/// Gives edit layers of one coat its new name; those of a coat that is gone then store the changes of all.
std::vector<EditLayer> with_coats(std::vector<EditLayer> layers, const std::vector<NamedCoat>& before,
                                  const std::vector<NamedCoat>& after);

/// Returns what the command does to the fields: new coats begin, and those that are removed leave nothing.
FieldDelta change_coats(const SetCoats& command, const std::vector<NamedCoat>& coats, const FieldSet& fields);

/// The coats that a tool works on, by the names that it gives and by its edit layer, in the scene's order.
std::vector<CoatId> coats_to_groom(const std::vector<std::string>& names, const std::string& edit_layer,
                                   const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers);
/// Refused (invalid, "/coats/K" or "/coats"): a coat that is not there or is muted, or is not the edit layer's.
Status check_groomed_coats(const std::vector<std::string>& names, const std::string& edit_layer,
                           const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers);

}  // namespace pelage
