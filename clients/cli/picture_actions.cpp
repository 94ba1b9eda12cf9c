#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "clients/cli/actions.h"
#include "clients/cli/files.h"
#include "clients/cli/print.h"
#include "clients/cli/refinement.h"
#include "protocol/json/decode.h"
#include "protocol/json/decode_answers.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

/// The format that an output's ending stands for; PNG where it says nothing.
const char* format_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == "exr") return "exr";
  return ending == "jpg" || ending == "jpeg" ? "jpeg" : "png";
}

Parameters with_format(Parameters parameters, const std::string& output) {
  const auto names_format = [](const auto& parameter) { return parameter.first == "format"; };
  const bool given = std::any_of(parameters.begin(), parameters.end(), names_format);
  if (!given) parameters.emplace_back("format", format_of(output));
  return parameters;
}

/// Checked here too, so that a wrong line says so without a server.
Result<FrameRequest> request_of(const Options& options) {
  Result<FrameRequest> request = decode_frame_query(with_format(options.frame, options.output));
  const Result<Tracing> tracing = decode_tracing_query(options.trace);
  if (!request || !tracing) return request ? tracing.status() : request;
  const bool strands = request->knobs.method == Method::strands;
  if (options.refine) {
    request->refine = *tracing;
  } else if (strands) {
    request->knobs.trace = *tracing;
  } else if (!options.trace.empty()) {
    return failure(Code::invalid, "Only strands are traced.", "/" + options.trace.front().first,
                   "--quality reference, or --refine");
  }
  return decode_frame_request(encode(*request));
}

void print_frame(const Options& options, const HttpAnswer& answer) {
  const std::string revision = header(answer, "pelage-revision"), quality = header(answer, "pelage-quality");
  const std::string timing = header(answer, "server-timing"), trace = header(answer, "pelage-trace");
  const std::string estimate = header(answer, "pelage-error");
  if (options.json) {
    fmt::print("{{\"file\":{},\"revision\":{},\"quality\":{},\"server_timing\":{}{}{}}}\n", json_text(options.output),
               revision, quality, json_text(timing), trace.empty() ? "" : ",\"trace\":" + trace,
               estimate.empty() ? "" : ",\"estimate\":" + estimate);
  } else {
    fmt::print("{}: revision {}, {}\n", options.output, revision, timing);
  }
}

}  // namespace

ExitCode draw_frame(Session& session) {
  const Options& options = session.options();
  const auto request = request_of(options);
  if (!request) return report(request.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  if (request->refine) return follow_refinement(session, *path, encode(*request));
  const auto answer = Session::accepted(session.connection().post_json(*path + "/frames", encode(*request)));
  if (!answer) return report(answer.status());
  if (const Status status = write_file(options.output, answer->body); !status.ok()) return report(status);
  if (options.output != "-") print_frame(options, *answer);
  return done;
}

ExitCode pick_pixel(Session& session) {
  const Options& options = session.options();
  const auto view = decode_frame_query(options.frame);
  if (!view) return report(view.status());
  const PickRequest request{.view = {view->camera, view->width, view->height}, .pixel = {options.x, options.y}};
  const std::string body = encode(request);
  if (const auto checked = decode_pick(body); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().post_json(*path + "/pick", body));
  if (!answer) return report(answer.status());
  const auto pick = decode_pick_answer(answer->body);
  if (!pick) return report(pick.status());
  if (options.json)
    fmt::print("{}\n", answer->body);
  else
    print(*pick);
  return done;
}

}  // namespace pelage
