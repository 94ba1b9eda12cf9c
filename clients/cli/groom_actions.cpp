#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "clients/cli/actions.h"
#include "clients/cli/print.h"
#include "clients/cli/steps.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::size_t short_run = 20;  // steps up to which each one is printed

/// Says on standard error how far a long run is: about once a second, and over one line on a terminal.
class Progress {
 public:
  explicit Progress(std::size_t steps) : steps_(steps), terminal_(isatty(STDERR_FILENO) != 0) {}

  void step(std::size_t number) {
    const auto now = std::chrono::steady_clock::now();
    if (steps_ <= short_run || (now - last_ < std::chrono::seconds(1) && number != steps_)) return;
    last_ = now;
    fmt::print(stderr, "{}step {} of {}{}", terminal_ ? "\r" : "", number, steps_,
               terminal_ && number != steps_ ? "" : "\n");
  }

 private:
  std::size_t steps_;
  bool terminal_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What was sent, and what came of it.
struct RunTotals {
  Revision revision = 0;
  std::size_t touched = 0;
  FieldsHash hash;
};

void add(RunTotals& totals, const CommandAnswer& answer) {
  totals.revision = answer.revision;
  totals.hash = answer.fields_hash;
  for (const CommandResult& result : answer.results) totals.touched += result.touched;
}

HttpHeaders headers_of(const Options& options, std::size_t step) {
  // Later steps come after our own changes, and so at other revisions.
  if (!options.if_match || step > 0) return {};
  return {{"If-Match", fmt::format("\"{}\"", *options.if_match)}};
}

ExitCode report_step(const RunStep& step, Status status) {
  status.pointer.insert(0, step.pointer);
  return report(status, step.place);
}

ExitCode run_steps(Session& session, const std::string& address, const std::vector<RunStep>& steps) {
  const Options& options = session.options();
  const bool each = steps.size() <= short_run && !options.json;
  Progress progress(steps.size());
  RunTotals totals;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto answer =
        Session::accepted(session.connection().post_json(address, steps[i].text, headers_of(options, i)));
    if (!answer) {
      if (i > 0) fmt::print(stderr, "pelage: {} steps before it are done, revision {}\n", i, totals.revision);
      return report_step(steps[i], answer.status());
    }
    const auto result = decode_answer<CommandAnswer>(answer->body);
    if (!result) return report_step(steps[i], result.status());
    add(totals, *result);
    if (options.json) fmt::print("{}\n", answer->body);
    if (each) print(*result);
    progress.step(i + 1);
  }
  if (!each && !options.json) {
    fmt::print("{} steps, touched {} in all\nrevision {}\nfields {}\n", steps.size(), totals.touched, totals.revision,
               to_hex(totals.hash));
  }
  return done;
}

/// What each command would touch after those before it: one request for all of them.
ExitCode try_steps(Session& session, const std::string& address, const std::vector<RunStep>& steps) {
  const Options& options = session.options();
  const auto batch = batch_of(steps);
  if (!batch) return report(batch.status(), options.file);
  const auto answer =
      Session::accepted(session.connection().post_json(address + "?dry_run=1", *batch, headers_of(options, 0)));
  if (!answer) return report(answer.status(), "a dry run of all steps of " + options.file + " as one batch");
  const auto result = decode_answer<CommandAnswer>(answer->body);
  if (!result) return report(result.status(), options.file);
  if (options.json) {
    fmt::print("{}\n", answer->body);
    return done;
  }
  std::size_t number = 0;
  for (const RunStep& step : steps) {
    fmt::print("{}{}{}\n", step.place, step.pointer.empty() ? "" : " ", step.pointer);
    for (std::size_t k = 0; k < step.commands.size() && number < result->results.size(); ++k) {
      fmt::print("  ");
      print(result->results[number++]);
    }
  }
  fmt::print("nothing is changed, revision {}\n", result->revision);
  return done;
}

}  // namespace

ExitCode run_file(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  std::string place;
  const auto steps = read_steps(session, *path, place);
  if (!steps) return report(steps.status(), place);
  const std::string address = *path + "/commands";
  return session.options().dry_run ? try_steps(session, address, *steps) : run_steps(session, address, *steps);
}

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

/// What takes the step's place: the commands of the file, all as one step.
Result<AmendRequest> amendment(Session& session, const std::string& path, std::string& place) {
  AmendRequest request{.revision = session.options().count, .commands = {}};
  if (session.options().drop) return request;
  const auto steps = read_steps(session, path, place);
  if (!steps) return steps.status();
  for (const RunStep& step : *steps)
    request.commands.insert(request.commands.end(), step.commands.begin(), step.commands.end());
  return request;
}

}  // namespace

ExitCode amend_step(Session& session) {
  const Options& options = session.options();
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  std::string place = options.file;
  const auto request = amendment(session, *path, place);
  if (!request) return report(request.status(), place);
  HttpHeaders headers;
  if (options.if_match) headers.emplace("If-Match", fmt::format("\"{}\"", *options.if_match));
  const std::string address = *path + "/amend" + (options.dry_run ? "?dry_run=1" : "");
  const auto answer = Session::accepted(session.connection().post_json(address, encode(*request), headers));
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
