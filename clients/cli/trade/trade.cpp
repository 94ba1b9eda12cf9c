#include "clients/cli/trade/trade.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "clients/cli/print.h"
#include "clients/cli/trade/sweep.h"
#include "protocol/json/decode.h"

namespace pelage {

namespace {

using namespace pelage::trade;

constexpr std::size_t max_table_bytes = std::size_t{256} << 20;

/// Says on standard error what is done and how long the rest may take: over one line on a terminal, else every 5 s.
class Progress {
 public:
  explicit Progress(double work) : all_(work), terminal_(isatty(STDERR_FILENO) != 0) {}

  void add(double work, const std::string& scene) {
    done_ += work;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(terminal_ ? 300 : 5000) && done_ < all_) return;
    last_ = now;
    const double passed = std::chrono::duration<double>(now - start_).count();
    const double left = passed * std::max(all_ - done_, 0.0) / done_;
    fmt::print(stderr, "{}{:3.0f} %, {:.0f} s passed, about {:.0f} s left: {}{}", terminal_ ? "\r\x1b[K" : "",
               100 * std::min(done_ / all_, 1.0), passed, left, scene, terminal_ ? "" : "\n");
  }

  void end() const {
    if (terminal_) fmt::print(stderr, "\n");
  }

 private:
  double all_, done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_ = start_;
};

SweepOptions sweep_options(const Options& options) {
  if (!options.quick) return {false, options.size, options.truth, options.r2_passes, options.repeats};
  return {true, std::min(options.size, 96), std::min(options.truth, 64), std::min(options.r2_passes, 4), 1};
}

/// Scenes that the user names, or else the built-in ones.
Result<std::vector<Case>> cases_for(Session& session) {
  const Options& options = session.options();
  if (options.scenes.empty()) return built_in_cases(options.quick);
  std::vector<Case> cases;
  for (const std::string& wanted : options.scenes) {
    const auto id = session.scene_id(wanted);
    if (!id) return id.status();
    const auto answer = Session::accepted(session.connection().get("/v1/scenes/" + *id));
    if (!answer) return answer.status();
    const auto summary = decode_answer<SceneSummary>(answer->body);
    if (!summary) return summary.status();
    for (Case& one : cases_of(*id, summary->name)) {
      if (!options.quick || one.swept) cases.push_back(std::move(one));
    }
  }
  return cases;
}

/// What the server draws with, as its metrics say.
Result<std::string> renderer_of(Session& session) {
  const auto answer = Session::accepted(session.connection().get("/metrics"));
  if (!answer) return answer.status();
  static const std::string mark = "pelage_renderer_info{renderer=\"";
  const std::size_t begin = answer->body.find(mark);
  if (begin == std::string::npos) return std::string("a renderer that the server does not name");
  const std::size_t from = begin + mark.size(), end = answer->body.find("\"} ", from);
  return answer->body.substr(from, end - from);
}

Result<std::vector<Row>> rows_before(const Options& options, const std::string& table) {
  if (!options.resume || !std::filesystem::exists(table)) return std::vector<Row>{};
  const auto text = read_file(table, max_table_bytes);
  return text ? from_csv(*text) : text.status();
}

Status measure(Session& session, const std::vector<Case>& cases, const std::string& table, Report& report) {
  const SweepOptions options = sweep_options(session.options());
  report.size = options.size, report.repeats = options.repeats, report.truth = options.truth;
  double work = 0;
  for (const Case& one : cases) work += work_of(one, options);
  Progress progress(work);
  for (const Case& one : cases) {
    const auto done = [&](double part) {
      progress.add(part, one.name);
      return write_file(table, to_csv(report.rows));
    };
    if (Status status = sweep(session, one, options, report, done); !status.ok()) return status;
  }
  progress.end();
  return {};
}

Status write_report(Session& session) {
  const std::string folder = session.options().output, table = folder + "/results.csv";
  const auto cases = cases_for(session);
  if (!cases) return cases.status();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return with_next(failure(Code::internal, "Cannot make the folder " + folder + ": " + error.message() + "."),
                     "name a folder in which you may write");
  }
  auto before = rows_before(session.options(), table);
  if (!before) return before.status();
  auto renderer = renderer_of(session);
  if (!renderer) return renderer.status();
  Report report{.renderer = std::move(*renderer), .rows = std::move(*before)};
  if (Status status = measure(session, *cases, table, report); !status.ok()) return status;
  if (Status status = write_file(folder + "/index.html", page(report)); !status.ok()) return status;
  fmt::print("{0}/index.html\n{0}/results.csv\n", folder);
  return {};
}

}  // namespace

ExitCode measure_trade(Session& session) {
  const Status status = write_report(session);
  return status.ok() ? done : report(status);
}

}  // namespace pelage
