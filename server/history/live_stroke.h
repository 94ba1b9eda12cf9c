// Strokes that arrive in parts while the pointer moves, and form one undo step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"

namespace pelage {

/// Tracks the stroke that the last step belongs to. Any other change of the scene ends it.
class LiveStroke {
 public:
  /// What to evaluate and log for a command, given the earlier parts of its stroke.
  struct Plan {
    Command merged;      // to evaluate: the stroke with all parts so far
    Command to_log;      // to log: the samples since the last entry, as the next part of the step
    bool joins = false;  // evaluate from the state before the last step, and join that step
  };

  /// Plans a resolved command; one without a stroke id is its own plan. Refuses (invalid) a part that is out of order
  /// or changes the tool or its settings, and (conflict) a part after the last one.
  Result<Plan> plan(const Command& command) const;

  /// Returns whether the command continues a stroke that has changed something.
  bool joins(const Command& command) const;

  /// Records that the plan was carried out. `changed` says whether it made or joined a step.
  void accept(const Plan& plan, const Command& command, bool changed);
  /// Ends the stroke, because something else changed the scene.
  void end();
  /// Returns whether further parts may follow.
  bool is_live() const { return !id_.empty() && !finished_; }

 private:
  Result<Plan> next_part(const Command& command) const;

  std::string id_;  // "" when no stroke is live
  std::uint32_t next_part_ = 0;
  std::uint32_t logged_parts_ = 0;
  bool finished_ = false;
  Command merged_;
  std::vector<StrokeSample> unlogged_;  // samples of parts that changed nothing
};

}  // namespace pelage
