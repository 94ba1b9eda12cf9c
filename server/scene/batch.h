// Evaluates a batch of commands without changing the scene.
#pragma once

#include <memory>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/groom/cancel.h"
#include "server/history/history.h"
#include "server/scene/map_pictures.h"
#include "server/surface/surface.h"

namespace pelage {

struct Outcome {
  FieldSet fields;                                // the fields after all commands
  FieldDelta delta;                               // combined change of all commands
  std::shared_ptr<const SceneSettings> settings;  // the settings after all commands; null if no setting changed
  std::vector<CommandResult> results;             // one for each command
  std::vector<std::size_t> effective;             // indices of the commands that changed anything

  bool changed() const { return settings || !delta.empty(); }
};

/// A resolved command with the inputs that it reads in addition to the scene's fields.
struct Step {
  Command command;
  std::shared_ptr<const FieldSet> baseline;         // fields that an erase restores or a retarget takes; else null
  std::shared_ptr<const Surface> source = nullptr;  // retarget: the surface that those fields lie on; else null
  ReadPictures pictures = {};
};

/// Prefixes the pointer of an error with "/commands/K", K being `command`, if there is more than one command.
Status in_batch(Status status, std::size_t command, std::size_t commands);

/// Evaluates the commands in order, each on the result of those before it. `start` is applied to `fields` first and
/// counts as part of the first command's change; a part of a stroke passes the delta that takes back the stroke so far.
/// `next` is the revision that the commands lead to. Fails (unavailable) if cancelled.
Result<Outcome> evaluate_batch(const std::vector<Step>& steps, const FieldDelta& start, const Surface& surface,
                               const FieldSet& fields, const SceneSettings& settings, Revision next,
                               const Cancel& cancel);

/// Refuses (invalid, "/stroke/part") a command that holds only a part of a stroke.
Status check_complete_stroke(const Command& command);

/// Returns the commands at the given indices.
std::vector<Command> chosen(const std::vector<Command>& commands, const std::vector<std::size_t>& numbers);

/// Describes a change of the fields for an answer. `fields` may be those before or after the change.
CommandResult describe_change(std::string op, const FieldDelta& delta, const FieldSet& fields);

// Checks the cost of commands before any of them begins.

/// Refuses (invalid) commands whose estimated work exceeds the limit. `symmetry` applies until a command of the batch
/// sets another one.
Status check_cost(const std::vector<Step>& steps, Symmetry symmetry, const Surface& surface, const FieldSet& fields);

}  // namespace pelage
