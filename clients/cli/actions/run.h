// Running the steps of a plan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/actions/steps.h"
#include "clients/cli/session.h"

namespace pelage {

/// What was sent, and what came of it.
struct RunTotals {
  std::size_t steps = 0;
  Revision revision = 0;
  std::size_t touched = 0;            // of all commands
  std::vector<std::string> warnings;  // each with the step that it is about
  double seconds = 0;
};

/// Sends step after step, the first of them only at the revision `if_match`. Reports what stops it.
ExitCode run_steps(Session& session, const std::string& path, const RunPlan& plan,
                   const std::optional<Revision>& if_match, RunTotals& totals);

/// "4 steps, 1234 vertices touched, 1 warning, 0.31 s"
std::string words_of(const RunTotals& totals);

/// Runs the plan, and runs it anew in its place each time one of its files changes, until Ctrl-C.
ExitCode watch_and_run(Session& session, const std::string& path);

}  // namespace pelage
