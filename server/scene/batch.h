// Evaluates several commands without changing anything.
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
  FieldSet fields;                                // after all commands
  FieldDelta delta;                               // of all commands together
  std::shared_ptr<const SceneSettings> settings;  // after them; null when they changed none
  std::vector<CommandResult> results;             // of each command
  std::vector<std::size_t> effective;             // numbers of the commands that changed anything

  bool changed() const { return settings || !delta.empty(); }
};

/// A resolved command, and what it reads beside the scene's fields.
struct Step {
  Command command;
  std::shared_ptr<const FieldSet> baseline;         // of erase: what it goes back to; of retarget: what it takes
  std::shared_ptr<const Surface> source = nullptr;  // of retarget: where that lies
  ReadPictures pictures = {};
};

/// Extends the pointer of a refusal in a batch, so that it says which command the refusal is about.
Status in_batch(Status status, std::size_t command, std::size_t commands);

/// Evaluates commands one after the other, each on the result of those before it. With `start`, their change is counted
/// from before `start` was applied to `fields`. `next` is the revision that the commands lead to. Ends early
/// (unavailable) once nobody waits.
Result<Outcome> evaluate_batch(const std::vector<Step>& steps, const FieldDelta& start, const Surface& surface,
                               const FieldSet& fields, const SceneSettings& settings, Revision next,
                               const Cancel& cancel);

/// Refused (invalid, "/stroke/part") for a part of a stroke.
Status check_whole(const Command& command);

/// Returns the commands with the given numbers.
std::vector<Command> chosen(const std::vector<Command>& commands, const std::vector<std::size_t>& numbers);

/// Describes a change of the fields for an answer. `fields` are those before it or after it.
CommandResult describe_change(std::string op, const FieldDelta& delta, const FieldSet& fields);

// Checks the cost of commands before any of them begins.

/// Refused (invalid) when the commands are too much work together; those before one may change its symmetry.
Status check_cost(const std::vector<Step>& steps, Symmetry symmetry, const Surface& surface, const FieldSet& fields);

}  // namespace pelage
