// Runs the steps of a plan, once or each time its files change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/actions/steps.h"
#include "clients/cli/session.h"

namespace pelage {

/// Totals over the steps that were sent.
struct RunTotals {
  std::size_t steps = 0;
  Revision revision = 0;
  std::size_t touched = 0;            // vertices, summed over all commands
  std::vector<std::string> warnings;  // each names its command and step
  double seconds = 0;
};

/// Sends the steps one after the other. With `if_match`, the first one is sent only if the scene is at that revision.
/// Stops at the first failure and reports it.
ExitCode run_steps(Session& session, const std::string& path, const RunPlan& plan,
                   const std::optional<Revision>& if_match, RunTotals& totals);

/// Returns text such as "4 steps, 1234 vertices touched, 1 warning, 0.31 s".
std::string summary_of(const RunTotals& totals);

/// Runs the plan; each time one of its files changes, undoes it and runs it again, until Ctrl-C.
ExitCode watch_and_run(Session& session, const std::string& path);

}  // namespace pelage
