// The steps of a run: from a recipe or from a log, checked before any of them is sent.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/session.h"
#include "protocol/commands/command.h"
#include "protocol/commands/recipe.h"

namespace pelage {

/// One undo step.
struct RunStep {
  std::string text;                  // as it is sent
  std::vector<Command> commands;     // what it says
  std::string place;                 // "step 3 of 12 of show.json"
  std::string pointer;               // to it, within the file; "" in a log
  std::vector<TouchLimits> asserts;  // what its commands have to touch
};

/// What the files of the options say. `place` and `files` can be used even if reading them failed.
struct RunPlan {
  std::vector<RunStep> steps;
  std::string place;               // what a refusal is about
  std::vector<std::string> files;  // that were read
};

/// Reads the steps of the file that the options name; the server turns a recipe into those for the scene at `path`. Ids
/// stand for the names of scenes that fields are taken from.
Status read_steps(Session& session, const std::string& path, RunPlan& plan);

/// Refuses the results of a step where a command touched more or less than its assert says.
Status check_asserts(const RunStep& step, const std::vector<CommandResult>& results);

/// All commands as one batch, for a dry run. Refused when they are more than one request takes.
Result<std::string> batch_of(const std::vector<RunStep>& steps);

}  // namespace pelage
