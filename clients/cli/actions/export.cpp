#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "base/limits.h"
#include "base/percent.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/upload.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"
#include "protocol/json/names.h"

namespace pelage {

namespace {

/// Returns the export parameters after checking them. Without --format, the output's file extension chooses the format;
/// .glb means `shells`, which any glTF viewer shows.
Result<Query> checked_export_query(const Options& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  Query query = options.export_parameters;
  const bool named = std::any_of(query.begin(), query.end(), [](const auto& each) { return each.first == "format"; });
  if (!named)
    query.emplace_back("format", extension == ".glb" ? "shells" : extension.empty() ? "" : extension.substr(1));
  const auto checked = decode_export_query(query);
  if (checked) return query;
  Status refused = checked.status();
  if (!named && refused.pointer == "/format")
    refused = failure(Code::invalid, "No format has the ending of " + options.output + "; change it or give --format.",
                      "", ".usda | .hair | .glb | .pelage");
  return refused;
}

/// Builds the URL of an export. The decoder has checked every value, so none needs escaping; only the + sign of a
/// number is dropped, because a URL would read it as a space.
std::string address_of_export(const std::string& scene_path, const Query& query, bool dry_run) {
  std::string parameters = dry_run ? "&dry_run=1" : "", format;
  for (auto [name, value] : query) {
    std::erase(value, '+');
    if (name == "format")
      format = value;
    else
      parameters += "&" + name + "=" + value;
  }
  if (!parameters.empty()) parameters[0] = '?';
  return scene_path + "/export/" + format + parameters;
}

std::string counts_of(const ExportAnswer& about) {
  if (about.format == ExportFormat::pelage) return fmt::format("revision {}", about.revision);
  if (holds_strands(about.format)) return fmt::format("{} strands, {} points", about.strands, about.points);
  if (about.format == ExportFormat::cards) return fmt::format("{} cards, {} triangles", about.cards, about.triangles);
  return fmt::format("{} triangles", about.triangles);
}

void print_export(const Options& options, const std::string& about) {
  const auto answer = decode_answer<ExportAnswer>(about);
  if (options.json || !answer) return fmt::print("{}\n", about);
  fmt::print("{}{}: {}, {:.1f} MB\n", options.output, options.dry_run ? " would hold" : "", counts_of(*answer),
             static_cast<double>(answer->bytes) / 1e6);
}

/// Streams the answer into the file. `written` becomes false if the file could not be written.
Result<HttpAnswer> stream_into_file(Session& session, const std::string& address, NewFile& file, bool& written) {
  std::atomic<std::size_t> bytes = 0;
  const ProgressLine line("exporting", [&bytes]() -> ProgressState {
    return {-1, bytes > 0 ? fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6) : ""};
  });
  return session.connection().get(address, [&](std::string_view chunk) {
    bytes += chunk.size();
    return written = file.write(chunk);
  });
}

ExitCode write_export(Session& session, const std::string& address) {
  NewFile file(session.options().output);
  bool written = true;
  const auto answer = stream_into_file(session, address, file, written);
  if (written) {  // otherwise commit() below reports the file error
    const auto accepted = Session::accepted(answer);
    if (!accepted) return report(accepted.status());
  }
  if (const Status status = file.commit(); !status.ok()) return report(status);
  print_export(session.options(), header(*answer, "pelage-export"));
  return done;
}

}  // namespace

ExitCode export_fur(Session& session) {
  const Options& options = session.options();
  const Result<Query> query = checked_export_query(options);
  if (!query) return report(query.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const std::string address = address_of_export(*path, *query, options.dry_run);
  if (!options.dry_run) return write_export(session, address);
  const auto answer = Session::accepted(session.connection().get(address));
  if (!answer) return report(answer.status());
  print_export(options, answer->body);
  return done;
}

ExitCode open_saved(Session& session) {
  const Options& options = session.options();
  const auto bytes = read_file(options.file, limits::model_bytes);
  if (!bytes) return report(bytes.status());
  const std::string name = options.name == Options{}.name ? "" : "?name=" + percent_encoded(options.name);
  const auto answer = post_with_progress(session, "/v1/open" + name, *bytes);
  if (!answer) return report(answer.status(), options.file);
  const auto summary = decode_answer<SceneSummary>(answer->body);
  if (!summary) return report(summary.status());
  fmt::print("{}\n", options.json ? answer->body : summary->id);
  return done;
}

}  // namespace pelage
