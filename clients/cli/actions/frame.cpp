#include <fmt/format.h>

#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/formats.h"
#include "clients/cli/actions/progressive.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

const ExtensionFormats frame_formats{{"", "png"},       {".png", "png"}, {".jpg", "jpeg"}, {".jpeg", "jpeg"},
                                     {".webp", "webp"}, {".exr", "exr"}, {".npy", "npy"}};

/// Checks the request on the client's side too, so that a wrong command line is refused without a server.
Result<FrameRequest> frame_request_of(const Options& options) {
  const Result<Parameters> parameters = with_format(options.frame, options.output, frame_formats);
  if (!parameters) return parameters.status();
  Result<FrameRequest> request = decode_frame_query(*parameters);
  const Result<Tracing> tracing = decode_tracing_query(options.trace);
  if (!request || !tracing) return request ? tracing.status() : request;
  const bool strands = request->knobs.method == Method::strands;
  if (options.progressive) {
    request->progressive = *tracing;
  } else if (strands) {
    request->knobs.trace = *tracing;
  } else if (!options.trace.empty()) {
    return failure(Code::invalid, "Only traced pictures take this option.", "/" + options.trace.front().first,
                   "--quality reference, or --progressive");
  }
  return decode_frame_request(encode(*request));
}

void print_frame(const Options& options, const HttpAnswer& answer) {
  const std::string revision = header(answer, "pelage-revision"), quality = header(answer, "pelage-quality");
  const std::string timing = header(answer, "server-timing"), trace = header(answer, "pelage-trace");
  const std::string estimate = header(answer, "pelage-error"), missed = header(answer, "pelage-missed");
  if (options.json) {
    fmt::print("{{\"file\":{},\"revision\":{},\"quality\":{},\"server_timing\":{}{}{}{}}}\n", json_text(options.output),
               revision, quality, json_text(timing), trace.empty() ? "" : ",\"trace\":" + trace,
               estimate.empty() ? "" : ",\"estimate\":" + estimate,
               missed.empty() ? "" : ",\"missed\":" + json_text(missed));
  } else {
    fmt::print("{}: revision {}, {}\n", options.output, revision, timing);
    if (!missed.empty()) fmt::print("limits not met: {}\n", missed);
  }
}

ExitCode print_cost(Session& session, const std::string& path, const std::string& request) {
  const auto answer = Session::accepted(session.connection().post_json(path + "/frames?dry_run=1", request));
  if (!answer) return report(answer.status());
  const auto cost = decode_answer<FrameCost>(answer->body);
  if (!cost) return report(cost.status());
  if (session.options().json)
    fmt::print("{}\n", answer->body);
  else
    fmt::print("about {:.2g} s, up to {:.2g}\n", cost->seconds, cost->seconds * cost->safety);
  return done;
}

/// Returns the progress of the frame with the largest done share, which is the one being drawn. Needs its own
/// connection, because the other one waits for the frame.
ProgressState frame_progress(Connection& connection, const std::string& path) {
  const auto answer = connection.get(path + "/frames");
  const auto list =
      answer ? decode_answer<FrameProgressList>(answer->body) : Result<FrameProgressList>(answer.status());
  ProgressState state;
  if (!list) return state;
  for (const FrameProgress& frame : list->frames)
    if (frame.share > state.share) state = {frame.share, fmt::format("of about {:.0f} s", frame.expected_seconds)};
  return state;
}

/// Draws a frame. If the server refuses it as too slow, the error says how to get it nevertheless.
Result<HttpAnswer> drawn(Session& session, const std::string& path, const std::string& request) {
  auto other = Connection::to(session.options().server, session.options().token);
  const ProgressLine line("drawing", [&] { return other ? frame_progress(*other, path) : ProgressState{}; });
  auto answer = Session::accepted(session.connection().post_json(path + "/frames", request));
  if (answer || answer.status().pointer != "/max_seconds") return answer;
  return with_next(answer.status(), "take a lower --quality or a smaller picture, or allow more with --max-seconds");
}

}  // namespace

ExitCode draw_frame(Session& session) {
  const Options& options = session.options();
  const auto request = frame_request_of(options);
  if (!request) return report(request.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  if (request->progressive) return follow_progressive(session, *path, encode(*request));
  if (options.dry_run) return print_cost(session, *path, encode(*request));
  const auto answer = drawn(session, *path, encode(*request));
  if (!answer) return report(answer.status());
  if (const Status status = write_file(options.output, answer->body); !status.ok()) return report(status);
  if (options.output != "-") print_frame(options, *answer);
  return done;
}

}  // namespace pelage
