#include "clients/cli/actions/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/limits.h"
#include "base/percent.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/upload.h"
#include "clients/cli/pack/pack.h"
#include "clients/cli/terminal/files.h"
#include "protocol/json/decode.h"

namespace pelage {

namespace {

/// Returns the file extension in lower case without its dot: "obj" for "spot.OBJ".
std::string extension_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

/// Returns the query parameters of an import. `format` is that of the bytes sent, "zip" for a packed model.
Query import_query(const Options& options, const std::string& format) {
  Query query{{"format", format},
              {"length", fmt::format("{}", options.length)},
              {"inclination", fmt::format("{}", options.inclination)},
              {"fur_patches", options.fur_patches},
              {"ground", options.ground ? "true" : "false"}};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) query.emplace_back(name, value);
  };
  add("up", options.up), add("front", options.front), add("pose", options.pose), add("form", options.form);
  add("crease_degrees", options.crease_degrees), add("flip", fmt::format("{}", fmt::join(options.flip, ",")));
  add("two_sided", fmt::format("{}", fmt::join(options.two_sided, ",")));
  return query;
}

/// Sends a PUT request with the bytes to the scene's resource `name`, such as "model".
Result<HttpAnswer> put_bytes(Session& session, const std::string& scene_path, const char* name, const Query& query,
                             const std::string& bytes) {
  std::string address = scene_path + "/" + name;
  char separator = '?';
  for (const auto& [parameter, value] : query)
    address += std::exchange(separator, '&') + parameter + "=" + percent_encoded(value);
  return put_with_progress(session, address, bytes);
}

Result<HttpAnswer> put_file(Session& session, const char* name, const Query& query, std::size_t max_bytes) {
  const auto bytes = read_file(session.options().file, max_bytes);
  if (!bytes) return bytes.status();
  const auto path = session.scene_path();
  return path ? put_bytes(session, *path, name, query, *bytes) : path.status();
}

/// Returns the model packed with the files that it references; standard input is taken as it is.
Result<PackedModel> packed(const Options& options, const std::string& format) {
  if (options.file != "-") {
    auto model = pack_model(options.file, format, limits::model_bytes);
    if (model || model.status().code != Code::not_found) return model;
  }
  const auto bytes = read_file(options.file, limits::model_bytes);
  if (!bytes) return bytes.status();
  return PackedModel{*bytes, false, {}};
}

/// Returns advice for the user on a model that the server refused. `pose` is the value of --pose.
std::string advice_on_refusal(const Status& status, const PackedModel& model, const std::string& pose) {
  const auto says = [&](const std::string& word) { return status.message.find(word) != std::string::npos; };
  for (const std::string& file : model.missing)
    if (says(file)) return "put " + file + " beside the model and load it again; the scene is as it was";
  if (!pose.empty() && (says("animation") || says("pose")))
    return "load it again with another --pose or without; the scene is as it was";
  return "mend or convert the file and load it again; the scene is as it was";
}

}  // namespace

Result<HttpAnswer> load_into(Session& session, const std::string& scene_path) {
  const Options& options = session.options();
  const std::string format = options.format.empty() ? extension_of(options.file) : options.format;
  if (const auto checked = decode_import_query(import_query(options, format)); !checked) return checked.status();
  const auto model = packed(options, format);
  if (!model) return model.status();
  Query query = import_query(options, model->is_zip ? "zip" : format);
  if (options.discard) query.emplace_back("discard", "1");
  auto answer = put_bytes(session, scene_path, "model", query, model->bytes);
  if (answer) return answer;
  const Status& status = answer.status();
  const bool about_the_file = status.code == Code::invalid && status.pointer.empty();
  return about_the_file ? with_next(status, advice_on_refusal(status, *model, options.pose)) : status;
}

ExitCode load_model(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const Result<HttpAnswer> answer = load_into(session, *path);
  return answer ? print_summary(session, answer) : report(answer.status(), session.options().file);
}

ExitCode load_environment(Session& session) {
  const Options& options = session.options();
  Query query = {{"intensity", fmt::format("{}", options.intensity)},
                 {"turn_degrees", fmt::format("{}", options.turn_degrees)}};
  if (!options.colour_space.empty()) query.emplace_back("colour_space", options.colour_space);
  if (const auto checked = decode_environment_query(query); !checked) return report(checked.status());
  return print_change(session, put_file(session, "environment", query, limits::picture_bytes), session.options().file);
}

ExitCode load_skin_texture(Session& session) {
  return print_change(session, put_file(session, "skin_texture", {}, limits::picture_bytes), session.options().file);
}

}  // namespace pelage
