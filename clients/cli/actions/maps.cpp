#include <fmt/format.h>

#include <utility>

#include "base/limits.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/formats.h"
#include "clients/cli/actions/upload.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

const ExtensionFormats guide_formats{{"", "usda"}, {".usda", "usda"}, {".hair", "hair"}, {".json", "json"}};
const ExtensionFormats map_formats{{"", "png16"}, {".png", "png16"}, {".exr", "exr"}, {".npy", "npy"}};

/// Returns the map's parameters together with its field, in the form that the decoder checks before anything is sent.
Query query_with_field(const Options& options) {
  Query query = options.map_parameters;
  query.emplace_back("field", options.field);
  return query;
}

/// Appends a query string. A decoder has checked every value, so none needs escaping; only the + sign of a number is
/// dropped, because a URL would read it as a space.
std::string with_parameters(std::string address, const Parameters& parameters) {
  char separator = '?';
  for (const auto& [parameter, value] : parameters) {
    std::string plain = value;
    std::erase(plain, '+');
    address += std::exchange(separator, '&') + parameter + "=" + plain;
  }
  return address;
}

std::string map_address(const std::string& scene_path, const Options& options) {
  return with_parameters(scene_path + "/maps/" + options.field, options.map_parameters);
}

}  // namespace

ExitCode get_map(Session& session) {
  Options options = session.options();
  const Result<Parameters> parameters = with_format(options.map_parameters, options.output, map_formats);
  if (!parameters) return report(parameters.status());
  options.map_parameters = *parameters;
  if (const auto checked = decode_map_query(query_with_field(options)); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = with_progress_line(
      "drawing the map", [&] { return Session::accepted(session.connection().get(map_address(*path, options))); });
  if (!answer) return report(answer.status());
  if (const Status status = write_file(options.output, answer->body); !status.ok()) return report(status);
  if (options.output == "-") return done;
  const std::string about = header(*answer, "pelage-map"), map = about.empty() ? "{}" : about;
  if (options.json)
    fmt::print("{{\"file\":{},\"map\":{}}}\n", json_text(options.output), map);
  else
    fmt::print("{}: {}\n", options.output, map);
  return done;
}

ExitCode put_map(Session& session) {
  const Options& options = session.options();
  if (const auto checked = decode_map_upload_query(query_with_field(options)); !checked)
    return report(checked.status());
  const auto bytes = read_file(options.file, limits::picture_bytes);
  if (!bytes) return report(bytes.status(), options.file);
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return print_change(session, put_with_progress(session, map_address(*path, options), *bytes), options.file);
}

ExitCode follow_guides(Session& session) {
  const Options& options = session.options();
  const auto query = with_format(options.guide_parameters, options.file, guide_formats);
  if (!query) return report(query.status());
  if (const auto checked = decode_guide_query(*query); !checked) return report(checked.status());
  const auto bytes = read_file(options.file, limits::guide_bytes);
  if (!bytes) return report(bytes.status(), options.file);
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const std::string address = with_parameters(*path + "/guides", *query);
  return print_change(session, put_with_progress(session, address, *bytes), options.file);
}

ExitCode put_picture(Session& session) {
  const Options& options = session.options();
  const auto bytes = read_file(options.file, limits::picture_bytes);
  if (!bytes) return report(bytes.status(), options.file);
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = put_with_progress(session, *path + "/pictures", *bytes);
  if (!answer) return report(answer.status(), options.file);
  const auto uploaded = decode_answer<PictureAnswer>(answer->body);
  if (!uploaded) return report(uploaded.status());
  fmt::print("{}\n", options.json ? answer->body : uploaded->picture);
  return done;
}

}  // namespace pelage
