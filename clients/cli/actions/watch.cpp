// `pelage run --watch`: runs a recipe again each time one of its files changes.
#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "clients/cli/actions/run.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"

namespace pelage {

namespace {

constexpr std::chrono::milliseconds poll_interval(100);

volatile std::sig_atomic_t interrupted = 0;

/// Makes the first Ctrl-C end the program after the current run; a second one ends it at once.
void end_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

using Stamps = std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>>;

/// Returns each file's modification time and size; default time and size 0 for a missing file.
Stamps stamps_of(const std::vector<std::string>& files) {
  Stamps stamps;
  for (const std::string& file : files) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    const auto size = error ? 0 : std::filesystem::file_size(file, error);
    stamps.emplace_back(error ? std::filesystem::file_time_type{} : time, error ? 0 : size);
  }
  return stamps;
}

/// Waits until a file differs from `known` and has stopped changing, because editors write a file in several steps.
/// Returns false after Ctrl-C.
bool wait_for_change(const std::vector<std::string>& files, const Stamps& known) {
  Stamps before = known;
  for (;;) {
    std::this_thread::sleep_for(poll_interval);
    if (interrupted) return false;
    const Stamps now = stamps_of(files);
    if (now != known && now == before) return true;
    before = now;
  }
}

Result<SceneSummary> summary_at(Session& session, const std::string& path) {
  const auto answer = Session::accepted(session.connection().get(path));
  return answer ? decode_answer<SceneSummary>(answer->body) : Result<SceneSummary>(answer.status());
}

/// Undoes all steps since `base`. Fails (precondition) if someone else changed the scene since revision `last`.
Status undo_since(Session& session, const std::string& path, const SceneSummary& base, Revision last) {
  const auto now = summary_at(session, path);
  if (!now) return now.status();
  if (now->revision != last)
    return with_next(failure(Code::precondition, "The scene was changed by someone else, and watching ends."),
                     "look at the scene with `pelage log`, and watch again from there");
  if (now->undo_steps <= base.undo_steps) return {};
  const std::string body = fmt::format("{{\"steps\":{}}}", now->undo_steps - base.undo_steps);
  const HttpHeaders headers{{"If-Match", fmt::format("\"{}\"", last)}};
  const auto answer = Session::accepted(session.connection().post_json(path + "/undo", body, headers));
  return answer ? Status{} : answer.status();
}

}  // namespace

ExitCode watch_and_run(Session& session, const std::string& path) {
  if (session.options().file == "-")
    return report(failure(Code::invalid, "Standard input cannot be watched.", "", "a file"));
  end_on_interrupt();
  const auto base = summary_at(session, path);
  if (!base) return report(base.status());
  Revision last = base->revision;
  for (;;) {
    RunPlan plan;
    Status status = read_steps(session, path, plan);
    const Stamps known = stamps_of(plan.files);
    if (status.ok()) {
      if (const Status refused = undo_since(session, path, *base, last); !refused.ok()) return report(refused);
      status = read_steps(session, path, plan);  // again: picks depend on the scene, now undone
    }
    RunTotals totals;
    if (!status.ok())
      report(status, plan.location);
    else if (run_steps(session, path, plan, {}, totals) == done && !session.options().json)
      fmt::print("{}, revision {}\n", summary_of(totals), totals.revision);
    std::fflush(stdout);
    const auto now = summary_at(session, path);
    if (!now) return report(now.status());
    last = now->revision;
    if (interrupted || !wait_for_change(plan.files, known)) return done;
  }
}

}  // namespace pelage
