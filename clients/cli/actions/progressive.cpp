#include "clients/cli/actions/progressive.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

#include "clients/cli/terminal/files.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double max_wait_seconds = 20;  // seconds that one request waits; the server allows at most 25

void print_progress(const Options& options, const HttpAnswer& answer, const TraceReport& trace, double seconds) {
  const std::string revision = header(answer, "pelage-revision");
  if (options.json) {
    fmt::print("{{\"file\":{},\"revision\":{},\"seconds\":{:.3f},\"trace\":{}}}\n", json_text(options.output), revision,
               seconds, header(answer, "pelage-trace"));
  } else if (trace.passes == 0) {
    fmt::print("{}: revision {}, rasterized, {:.2f} s\n", options.output, revision, seconds);
  } else {
    const std::string noise = trace.noise < 1 ? fmt::format(", noise {:.4f}", trace.noise) : "";  // 1: unknown yet
    fmt::print("{}: revision {}, {} pass{}{}, {:.2f} s\n", options.output, revision, trace.passes,
               trace.passes == 1 ? "" : "es", noise, seconds);
  }
  std::fflush(stdout);
}

/// Writes the picture to the output file and prints a line about it.
Result<TraceReport> take(const Options& options, const HttpAnswer& answer, double seconds) {
  Result<TraceReport> trace = decode_answer<TraceReport>(header(answer, "pelage-trace"));
  if (!trace) return trace;
  if (Status status = write_file(options.output, answer.body); !status.ok()) return status;
  print_progress(options, answer, *trace, seconds);
  return trace;
}

}  // namespace

ExitCode follow_progressive(Session& session, const std::string& path, const std::string& request) {
  const Options& options = session.options();
  if (options.output == "-") {
    return report(failure(Code::invalid, "Progressive pictures need a file.", "", "--output FILE"));
  }
  const Clock::time_point start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const double max = options.for_seconds.value_or(std::numeric_limits<double>::infinity());
  const int last_pass = options.until_pass.value_or(std::numeric_limits<int>::max());
  std::string address = path + "/frames";
  for (;;) {
    const auto answer = Session::accepted(session.connection().post_json(address, request));
    if (!answer) return report(answer.status());
    if (answer->status != 304) {
      const Result<TraceReport> trace = take(options, *answer, seconds());
      if (!trace) return report(trace.status());
      if (trace->end != TraceEnd::none || trace->passes >= last_pass) return done;
      address =
          fmt::format("{}/frames?after={}&after_pass={}", path, header(*answer, "pelage-revision"), trace->passes);
    }
    const double left = max - seconds();
    if (left <= 0) return done;
    const std::size_t wait = address.find("&wait=");
    address = fmt::format("{}&wait={:.3f}", address.substr(0, wait), std::min(left, max_wait_seconds));
  }
}

}  // namespace pelage
