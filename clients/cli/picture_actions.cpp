#include "clients/cli/picture_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <limits>

#include "clients/cli/actions.h"
#include "clients/cli/frame_watch.h"
#include "clients/cli/print.h"
#include "protocol/base/limits.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double longest_wait = 20;  // seconds of one request; the server takes 25

void print_progress(const Options& options, const HttpAnswer& answer, const TraceReport& trace, double seconds) {
  const std::string revision = header(answer, "pelage-revision");
  if (options.json) {
    fmt::print("{{\"file\":{},\"revision\":{},\"seconds\":{:.3f},\"trace\":{}}}\n", json_text(options.output), revision,
               seconds, header(answer, "pelage-trace"));
  } else if (trace.passes == 0) {
    fmt::print("{}: revision {}, shells, {:.2f} s\n", options.output, revision, seconds);
  } else {
    const std::string noise = trace.noise < 1 ? fmt::format(", noise {:.4f}", trace.noise) : "";  // 1: not known yet
    fmt::print("{}: revision {}, {} pass{}{}, {:.2f} s\n", options.output, revision, trace.passes,
               trace.passes == 1 ? "" : "es", noise, seconds);
  }
  std::fflush(stdout);
}

/// Writes the picture and says so.
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
    return report(failure(Code::invalid, "Pictures that follow each other need a file.", "", "--output FILE"));
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
    address = fmt::format("{}&wait={:.3f}", address.substr(0, wait), std::min(left, longest_wait));
  }
}

namespace {

/// The formats that endings stand for; that of none, as of standard output, comes first.
using Endings = std::vector<std::pair<std::string, const char*>>;
const Endings frame_endings{{"", "png"},       {".png", "png"}, {".jpg", "jpeg"},
                            {".jpeg", "jpeg"}, {".exr", "exr"}, {".npy", "npy"}};
const Endings map_endings{{"", "png16"}, {".png", "png16"}, {".exr", "exr"}, {".npy", "npy"}};

/// Refused (invalid) before any work is done.
Result<std::string> format_of(const std::string& path, const Endings& endings) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto known =
      std::find_if(endings.begin(), endings.end(), [&](const auto& each) { return each.first == ending; });
  if (known != endings.end()) return std::string(known->second);
  std::string all;
  for (std::size_t k = 1; k < endings.size(); ++k) all += (k > 1 ? " | " : "") + endings[k].first;
  return failure(Code::invalid, "No format has the ending of " + path + "; take another, or --format.", "", all);
}

/// The parameters with the format that the output's ending stands for, unless they name one.
Result<Parameters> with_format(Parameters parameters, const std::string& output, const Endings& endings) {
  const auto names_format = [](const auto& parameter) { return parameter.first == "format"; };
  if (std::any_of(parameters.begin(), parameters.end(), names_format)) return parameters;
  const Result<std::string> format = format_of(output, endings);
  if (!format) return format.status();
  parameters.emplace_back("format", *format);
  return parameters;
}

/// Checked here too, so that a wrong line says so without a server.
Result<FrameRequest> frame_request_of(const Options& options) {
  const Result<Parameters> parameters = with_format(options.frame, options.output, frame_endings);
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
    return failure(Code::invalid, "Only strands are traced.", "/" + options.trace.front().first,
                   "--quality reference, or --progressive");
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

/// A frame that is too long says how to get it all the same.
Result<HttpAnswer> drawn(Session& session, const std::string& path, const std::string& request) {
  const FrameWatch watch(session.options(), path);
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
  const auto pick = decode_answer<PickAnswer>(answer->body);
  if (!pick) return report(pick.status());
  if (options.json) {
    fmt::print("{}\n", answer->body);
    return done;
  }
  const auto scene = Session::accepted(session.connection().get(*path));
  const auto summary = scene ? decode_answer<SceneSummary>(scene->body) : Result<SceneSummary>(scene.status());
  if (!summary) return report(summary.status());
  print(*pick, summary->report.bounds);
  return done;
}

namespace {

/// The parameters and the field, for the decoder to check before anything is sent.
Query checked_query(const Options& options) {
  Query query = options.map_parameters;
  query.emplace_back("field", options.field);
  return query;
}

/// The address of the field's map. The decoder took every value, so that none needs escaping but the + of a number,
/// which means nothing there.
std::string address_of(const std::string& scene_path, const Options& options) {
  std::string address = scene_path + "/maps/" + options.field;
  char separator = '?';
  for (const auto& [parameter, value] : options.map_parameters) {
    std::string plain = value;
    std::erase(plain, '+');
    address += separator + parameter + "=" + plain;
    separator = '&';
  }
  return address;
}

}  // namespace

ExitCode get_map(Session& session) {
  Options options = session.options();
  const Result<Parameters> parameters = with_format(options.map_parameters, options.output, map_endings);
  if (!parameters) return report(parameters.status());
  options.map_parameters = *parameters;
  if (const auto checked = decode_map_query(checked_query(options)); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().get(address_of(*path, options)));
  if (!answer) return report(answer.status());
  if (const Status status = write_file(options.output, answer->body); !status.ok()) return report(status);
  if (options.output == "-") return done;
  const auto about = answer->headers.find("pelage-map");
  const std::string map = about == answer->headers.end() ? "{}" : about->second;
  if (options.json)
    fmt::print("{{\"file\":{},\"map\":{}}}\n", json_text(options.output), map);
  else
    fmt::print("{}: {}\n", options.output, map);
  return done;
}

ExitCode put_map(Session& session) {
  const Options& options = session.options();
  if (const auto checked = decode_map_upload_query(checked_query(options)); !checked) return report(checked.status());
  const auto bytes = read_file(options.file, limits::picture_bytes);
  if (!bytes) return report(bytes.status(), options.file);
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return print_change(session, Session::accepted(session.connection().put_bytes(address_of(*path, options), *bytes)),
                      options.file);
}

ExitCode put_picture(Session& session) {
  const Options& options = session.options();
  const auto bytes = read_file(options.file, limits::picture_bytes);
  if (!bytes) return report(bytes.status(), options.file);
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().put_bytes(*path + "/pictures", *bytes));
  if (!answer) return report(answer.status(), options.file);
  const auto kept = decode_answer<PictureAnswer>(answer->body);
  if (!kept) return report(kept.status());
  fmt::print("{}\n", options.json ? answer->body : kept->picture);
  return done;
}

}  // namespace pelage
