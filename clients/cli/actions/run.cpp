#include "clients/cli/actions/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "base/stopwatch.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/terminal/print.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"

namespace pelage {

namespace {

constexpr std::size_t max_printed_warnings = 8;

void add(RunTotals& totals, const RunStep& step, const CommandAnswer& answer) {
  ++totals.steps;
  totals.revision = answer.revision;
  for (const CommandResult& result : answer.results) {
    totals.touched += result.touched;
    for (const std::string& warning : result.warnings)
      totals.warnings.push_back(fmt::format("{} ({}, {})", warning, result.op, step.location));
  }
}

HttpHeaders headers_of(const std::optional<Revision>& if_match, std::size_t step) {
  // Only the first step is conditional: the steps themselves raise the scene's revision.
  if (!if_match || step > 0) return {};
  return {{"If-Match", fmt::format("\"{}\"", *if_match)}};
}

Status send_step(Session& session, const std::string& path, const RunStep& step, const HttpHeaders& headers,
                 RunTotals& totals) {
  const auto answer = Session::accepted(session.connection().post_json(path + "/commands", step.text, headers));
  const auto result = answer ? decode_answer<CommandAnswer>(answer->body) : Result<CommandAnswer>(answer.status());
  if (!result) {
    Status status = result.status();
    status.pointer.insert(0, step.pointer);
    return status;
  }
  add(totals, step, *result);
  if (session.options().json)
    fmt::print("{}\n", answer->body);
  else if (session.options().verbose)
    print(*result);
  return check_asserts(step, result->results);
}

ExitCode report_stop(const RunStep& step, const Status& status, const RunTotals& totals) {
  if (totals.steps > 0 && !reports_json())
    fmt::print(stderr, "pelage: {} steps are done, revision {}\n", totals.steps, totals.revision);
  return report(status, step.location);
}

ExitCode run_once(Session& session, const std::string& path, const RunPlan& plan) {
  RunTotals totals;
  const ExitCode code = run_steps(session, path, plan, session.options().if_match, totals);
  if (code != done || session.options().json) return code;
  fmt::print("{}\n", summary_of(totals));
  for (std::size_t k = 0; k < std::min(max_printed_warnings, totals.warnings.size()); ++k)
    fmt::print("warning: {}\n", totals.warnings[k]);
  if (totals.warnings.size() > max_printed_warnings)
    fmt::print("warning: and {} more; --verbose prints all\n", totals.warnings.size() - max_printed_warnings);
  fmt::print("revision {}\n", totals.revision);
  return done;
}

/// Prints what each command touched in a dry run of the plan, below the command's step.
void print_dry_run(const RunPlan& plan, const CommandAnswer& answer) {
  std::size_t number = 0;
  for (const RunStep& step : plan.steps) {
    fmt::print("{}{}{}\n", step.location, step.pointer.empty() ? "" : " ", step.pointer);
    for (std::size_t k = 0; k < step.commands.size() && number < answer.results.size(); ++k) {
      fmt::print("  ");
      print(answer.results[number++]);
    }
  }
  fmt::print("nothing is changed, revision {}\n", answer.revision);
}

/// Reports the first step whose assert fails in a dry run.
ExitCode check_dry_run(const RunPlan& plan, const CommandAnswer& answer) {
  auto begin = answer.results.begin();
  for (const RunStep& step : plan.steps) {
    const auto end = begin + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(step.commands.size()),
                                                      answer.results.end() - begin);
    if (const Status bad = check_asserts(step, {begin, end}); !bad.ok()) return report(bad, step.location);
    begin = end;
  }
  return done;
}

/// Makes a dry run of all steps as one request, so that each command sees the effect of those before it.
ExitCode try_steps(Session& session, const std::string& path, const RunPlan& plan) {
  const Options& options = session.options();
  const auto batch = batch_of(plan.steps);
  if (!batch) return report(batch.status(), options.file);
  const auto answer = with_progress_line("trying", [&] {
    return Session::accepted(
        session.connection().post_json(path + "/commands?dry_run=1", *batch, headers_of(options.if_match, 0)));
  });
  if (!answer) return report(answer.status(), "a dry run of all steps of " + options.file + " as one batch");
  const auto result = decode_answer<CommandAnswer>(answer->body);
  if (!result) return report(result.status(), options.file);
  if (options.json)
    fmt::print("{}\n", answer->body);
  else
    print_dry_run(plan, *result);
  return check_dry_run(plan, *result);
}

}  // namespace

std::string summary_of(const RunTotals& totals) {
  const auto counted = [](std::size_t count, const char* one, const char* more) {
    return fmt::format("{} {}", count, count == 1 ? one : more);
  };
  const std::string warnings =
      totals.warnings.empty() ? "" : ", " + counted(totals.warnings.size(), "warning", "warnings");
  return counted(totals.steps, "step", "steps") + ", " + counted(totals.touched, "vertex touched", "vertices touched") +
         warnings + fmt::format(", {:.2f} s", totals.seconds);
}

ExitCode run_steps(Session& session, const std::string& path, const RunPlan& plan,
                   const std::optional<Revision>& if_match, RunTotals& totals) {
  const Stopwatch passed;
  std::atomic<std::size_t> now = 0;
  std::optional<ProgressLine> line;
  if (!session.options().verbose)
    line.emplace("running", [&now, count = plan.steps.size()]() -> ProgressState {
      return {static_cast<double>(now) / static_cast<double>(count), fmt::format("step {} of {}", now + 1, count)};
    });
  for (; now < plan.steps.size(); ++now) {
    const RunStep& step = plan.steps[now];
    const Status status = send_step(session, path, step, headers_of(if_match, now), totals);
    if (status.ok()) continue;
    line.reset();
    return report_stop(step, status, totals);
  }
  totals.seconds = 1e-3 * passed.milliseconds();
  return done;
}

ExitCode run_file(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  if (session.options().watch) return watch_and_run(session, *path);
  RunPlan plan;
  if (const Status refused = read_steps(session, *path, plan); !refused.ok()) return report(refused, plan.location);
  return session.options().dry_run ? try_steps(session, *path, plan) : run_once(session, *path, plan);
}

}  // namespace pelage
