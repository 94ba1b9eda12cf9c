#include <fmt/format.h>

#include <algorithm>

#include "clients/cli/actions.h"
#include "clients/cli/files.h"
#include "clients/cli/print.h"
#include "protocol/base/limits.h"
#include "protocol/json/decode.h"
#include "protocol/json/decode_answers.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

bool ends_in_exr(const std::string& path) { return path.size() >= 4 && path.substr(path.size() - 4) == ".exr"; }

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

Options with_format(Options options) {
  const Parameters& given = options.map_parameters;
  const auto names_format = [](const auto& parameter) { return parameter.first == "format"; };
  const bool has_format = std::any_of(given.begin(), given.end(), names_format);
  if (!has_format && ends_in_exr(options.output)) options.map_parameters.emplace_back("format", "exr");
  return options;
}

}  // namespace

ExitCode get_map(Session& session) {
  const Options options = with_format(session.options());
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
  const auto kept = decode_picture_answer(answer->body);
  if (!kept) return report(kept.status());
  fmt::print("{}\n", options.json ? answer->body : kept->picture);
  return done;
}

}  // namespace pelage
