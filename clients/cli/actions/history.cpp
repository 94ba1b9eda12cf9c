#include <fmt/format.h>

#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/steps.h"
#include "clients/cli/terminal/print.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

ExitCode move_in_history(Session& session) {
  const Options& options = session.options();
  const bool reverting = options.action == Action::revert;
  const std::string body = fmt::format("{{\"{}\":{}}}", reverting ? "revision" : "steps", options.count);
  if (const auto steps = decode_steps(body); !reverting && !steps) return report(steps.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const std::string name = reverting ? "/revert" : options.action == Action::undo ? "/undo" : "/redo";
  return print_change(session, Session::accepted(session.connection().post_json(*path + name, body)));
}

ExitCode show_log(Session& session) {
  const Options& options = session.options();
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  std::string address = *path + (options.lines ? "/log?format=jsonl" : "/log");
  if (!options.other.empty()) {
    const auto other = session.scene_id(options.other);
    if (!other) return report(other.status());
    address += "&for=" + *other;
  }
  const auto answer = Session::accepted(session.connection().get(address));
  if (!answer) return report(answer.status());
  if (options.lines || options.json) {
    fmt::print("{}{}", answer->body, options.lines ? "" : "\n");
    return done;
  }
  const auto log = decode_answer<Log>(answer->body);
  if (!log) return report(log.status());
  print(log->entries);
  return done;
}

namespace {

/// Returns the request that replaces a step by all commands of the file, or by none with --drop.
Result<AmendRequest> amendment(Session& session, const std::string& path, RunPlan& plan) {
  AmendRequest request{.revision = session.options().count, .commands = {}};
  if (session.options().drop) return request;
  if (const Status refused = read_steps(session, path, plan); !refused.ok()) return refused;
  for (const RunStep& step : plan.steps)
    request.commands.insert(request.commands.end(), step.commands.begin(), step.commands.end());
  return request;
}

}  // namespace

ExitCode amend_step(Session& session) {
  const Options& options = session.options();
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  RunPlan plan;
  const auto request = amendment(session, *path, plan);
  if (!request) return report(request.status(), plan.location);
  HttpHeaders headers;
  if (options.if_match) headers.emplace("If-Match", fmt::format("\"{}\"", *options.if_match));
  const std::string address = *path + "/amend" + (options.dry_run ? "?dry_run=1" : "");
  const auto answer = with_progress_line("replaying the steps after it", [&] {
    return Session::accepted(session.connection().post_json(address, encode(*request), headers));
  });
  const ExitCode code = print_change(session, answer, options.file);
  if (code == done && options.dry_run && !options.json) fmt::print("nothing is changed\n");
  return code;
}

ExitCode branch_scene(Session& session) {
  const Options& options = session.options();
  const std::string request = encode(BranchRequest{options.name, options.revision});
  if (const auto checked = decode_branch(request); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = session.make_scene(*path + "/branch", request);
  if (!answer) return report(answer.status());
  const auto summary = decode_answer<SceneSummary>(answer->body);
  if (!summary) return report(summary.status());
  fmt::print("{}\n", options.json ? answer->body : summary->id);
  return done;
}

}  // namespace pelage
