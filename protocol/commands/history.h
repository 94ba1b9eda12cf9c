// What the history of a scene can be asked for beside commands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// A scene of its own that begins with another one's model, log and settings at a revision.
struct BranchRequest {
  std::string name = "branch";                 // 1 to 200 bytes
  std::optional<std::uint64_t> revision = {};  // [first of the model, present]; the present one when absent
};

/// Puts other commands in the place of an earlier step, and replays the steps after it.
struct AmendRequest {
  std::uint64_t revision = 0;     // one that the step has in the log, or its number; the step is still in effect
  std::vector<Command> commands;  // at most 1,000, strokes whole; none leaves the step out
};

}  // namespace pelage
