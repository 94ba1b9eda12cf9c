// The coats of a scene: the changes that set_coats makes to them and to their fields.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"

namespace pelage {

/// Returns the coat of a name; null if there is none. "" names the first coat.
const NamedCoat* find_coat(const std::vector<NamedCoat>& coats, const std::string& name);

/// Returns the coats as a summary lists them, without the parameters of their strands.
std::vector<CoatEntry> names_of(const std::vector<NamedCoat>& coats);

/// Returns the first coat that is not muted.
const NamedCoat& first_unmuted(const std::vector<NamedCoat>& coats);

/// Refuses (invalid, "/coats" or "/coats/K/..."): a new coat that begins from a missing one, `begins` for an existing
/// coat, more than limits::coats, and two entries for one coat.
Status check(const SetCoats& command, const std::vector<NamedCoat>& coats);
/// Refuses (invalid, "/name") a missing coat.
Status check(const SetCoat& command, const std::vector<NamedCoat>& coats);

/// Return the coats after a command, which has been checked.
std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoats& command);
std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoat& command);

/// Updates the name of the coat in edit layers that belong to one coat. Those of a removed coat then store the changes
/// of all coats.
std::vector<EditLayer> with_coats(std::vector<EditLayer> layers, const std::vector<NamedCoat>& before,
                                  const std::vector<NamedCoat>& after);

/// Returns the change of the fields: new coats get their first values, and removed coats lose theirs.
FieldDelta change_coats(const SetCoats& command, const std::vector<NamedCoat>& coats, const FieldSet& fields);

/// Returns the coats that a tool changes, in the scene's order: those in `names` (all if empty) that are not muted and,
/// if the edit layer belongs to one coat, only that coat.
std::vector<CoatId> coats_to_groom(const std::vector<std::string>& names, const std::string& edit_layer,
                                   const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers);
/// Refuses (invalid): a coat that is missing, muted or not the edit layer's ("/coats/K"), and an edit layer whose coat
/// is muted ("/edit_layer").
Status check_groomed_coats(const std::vector<std::string>& names, const std::string& edit_layer,
                           const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers);

}  // namespace pelage
