#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "clients/cli/actions.h"
#include "clients/cli/files.h"
#include "clients/cli/print.h"
#include "protocol/base/limits.h"
#include "protocol/json/decode.h"
#include "protocol/json/decode_answers.h"

namespace pelage {

namespace {

constexpr std::size_t command_file_bytes = std::size_t{1} << 30;
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

std::string step_name(const Options& options, std::size_t step, std::size_t steps) {
  return fmt::format("step {} of {} of {}", step + 1, steps, options.file);
}

ExitCode run_steps(Session& session, const std::string& address, const std::vector<std::string>& steps) {
  const Options& options = session.options();
  const bool each = steps.size() <= short_run && !options.json;
  Progress progress(steps.size());
  RunTotals totals;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto answer = Session::accepted(session.connection().post_json(address, steps[i], headers_of(options, i)));
    if (!answer) {
      if (i > 0) fmt::print(stderr, "pelage: {} steps before it are done, revision {}\n", i, totals.revision);
      return report(answer.status(), step_name(options, i, steps.size()));
    }
    const auto result = decode_command_answer(answer->body);
    if (!result) return report(result.status(), step_name(options, i, steps.size()));
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

/// All steps are checked before the first is sent.
Status check_steps(const std::vector<std::string>& steps, std::size_t& bad_step) {
  for (bad_step = 0; bad_step < steps.size(); ++bad_step) {
    const std::string& step = steps[bad_step];
    if (step.size() > limits::command_body_bytes) {
      return failure(Code::too_large, fmt::format("The step has {} bytes.", step.size()), "",
                     fmt::format("at most {} bytes", limits::command_body_bytes));
    }
    if (const auto commands = decode_commands(step); !commands) return commands.status();
  }
  return {};
}

}  // namespace

ExitCode run_file(Session& session) {
  const Options& options = session.options();
  const auto text = read_file(options.file, command_file_bytes);
  if (!text) return report(text.status());
  const auto steps = split_steps(*text);
  if (!steps) return report(steps.status(), options.file);
  std::size_t bad_step = 0;
  if (const Status status = check_steps(*steps, bad_step); !status.ok()) {
    return report(status, step_name(options, bad_step, steps->size()));
  }
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return run_steps(session, *path + (options.dry_run ? "/commands?dry_run=1" : "/commands"), *steps);
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
  const auto answer =
      Session::accepted(session.connection().get(*path + (options.lines ? "/log?format=jsonl" : "/log")));
  if (!answer) return report(answer.status());
  if (options.lines || options.json) {
    fmt::print("{}{}", answer->body, options.lines ? "" : "\n");
    return done;
  }
  const auto log = decode_log(answer->body);
  if (!log) return report(log.status());
  print(*log);
  return done;
}

}  // namespace pelage
