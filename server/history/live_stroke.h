// Strokes that come in parts while the pointer moves, and are one undo step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"

namespace pelage {

/// Knows the stroke that the last step belongs to. Anything else that changes the scene ends it.
class LiveStroke {
 public:
  /// What a command means, given the parts of the stroke before it.
  struct Plan {
    Command whole;       // what to evaluate: the stroke with all parts so far
    Command unlogged;    // what to log: the samples since the last entry, as the next part of the step
    bool joins = false;  // evaluate from before the last step, and join it
  };

  /// `command` is resolved; one without an id is its own plan. Refused: a part that is not the next one, or repeats
  /// the tool with other settings (invalid); a part after the last one (conflict).
  Result<Plan> plan(const Command& command) const;

  /// Returns whether the command continues a stroke that has changed something.
  bool joins(const Command& command) const;

  /// Records that the plan was carried out. `changed` says whether it made or joined a step.
  void accept(const Plan& plan, const Command& command, bool changed);
  /// Ends the stroke, because something else changed the scene.
  void end();
  /// Returns whether a part may follow.
  bool goes_on() const { return !id_.empty() && !finished_; }

 private:
  Result<Plan> next_part(const Command& command) const;

  std::string id_;  // "" when no stroke is live
  std::uint32_t next_part_ = 0;
  std::uint32_t logged_parts_ = 0;
  bool finished_ = false;
  Command whole_;
  std::vector<StrokeSample> unlogged_;  // of parts that changed nothing
};

}  // namespace pelage
