// The steps of `pelage run` and `pelage amend`, read from a recipe or a log and checked before any of them is sent.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/session.h"
#include "protocol/commands/command.h"
#include "protocol/commands/recipe.h"

namespace pelage {

/// One undo step.
struct RunStep {
  std::string text;                  // JSON that is sent to the server
  std::vector<Command> commands;     // decoded from `text`
  std::string location;              // for messages: "step 3 of 12, show.json"
  std::string pointer;               // JSON pointer to the step within its file; "" in a log
  std::vector<TouchLimits> asserts;  // limits on the vertices that its commands touch
};

/// All steps of a run. `location` and `files` are valid even if reading failed.
struct RunPlan {
  std::vector<RunStep> steps;
  std::string location;            // file or step that an error is about
  std::vector<std::string> files;  // files that were read
};

/// Reads the steps of the file that the options name. For a recipe, the server computes the steps for the scene at
/// `path`. Names of scenes in `retarget` commands are replaced by ids.
Status read_steps(Session& session, const std::string& path, RunPlan& plan);

/// Fails if a command of the step touched more or fewer vertices than its assert allows.
Status check_asserts(const RunStep& step, const std::vector<CommandResult>& results);

/// Encodes the commands of all steps as one batch, for a dry run. Fails (too_large) if they exceed one request's
/// limits.
Result<std::string> batch_of(const std::vector<RunStep>& steps);

}  // namespace pelage
