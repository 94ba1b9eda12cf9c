// Requests about the history of a scene: branch and amend.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// Makes a new scene with the model, log and settings of another one at a revision.
struct BranchRequest {
  std::string name = "branch";                 // 1 to 200 bytes
  std::optional<std::uint64_t> revision = {};  // [first of the model, present]; absent: the present one
};

/// Replaces the commands of an earlier step, and replays the steps after it.
struct AmendRequest {
  std::uint64_t revision = 0;     // a revision of the step in the log, or its number; the step must be in effect
  std::vector<Command> commands;  // at most 1,000, with whole strokes; an empty list removes the step
};

}  // namespace pelage
