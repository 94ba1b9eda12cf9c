// The steps of a run: from a recipe or from a log, checked before any of them is sent.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/session.h"
#include "protocol/commands/command.h"

namespace pelage {

/// One undo step.
struct RunStep {
  std::string text;               // as it is sent
  std::vector<Command> commands;  // what it says
  std::string place;              // "step 3 of 12 of show.json"
  std::string pointer;            // to it, within the file; "" in a log
};

/// The steps of the file that the options name. A recipe's places are filled in from the box of the scene at `path`,
/// and ids stand for the names of scenes that fields are taken from. Gives a refusal that says which step of which file
/// it is about in `place`.
Result<std::vector<RunStep>> read_steps(Session& session, const std::string& path, std::string& place);

/// All commands as one batch, for a dry run. Refused when they are more than one request takes.
Result<std::string> batch_of(const std::vector<RunStep>& steps);

}  // namespace pelage
