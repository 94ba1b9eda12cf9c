#include "clients/cli/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "clients/cli/terminal/print.h"
#include "protocol/json/decode.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

/// Returns advice on HTTP errors that have no Code of their own; "" for others.
const char* advice_for(int http_status) {
  if (http_status == 401) return "give the server's token with --token or PELAGE_TOKEN";
  if (http_status == 403) return "start the server with --host and the name in its address";
  return "";
}

bool could_be_id(const std::string& text) {
  return !text.empty() && text.size() <= 64 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

}  // namespace

std::string header(const HttpAnswer& answer, const char* name) {
  const auto found = answer.headers.find(name);
  return found == answer.headers.end() ? "" : found->second;
}

Result<HttpAnswer> Session::accepted(Result<HttpAnswer> answer) {
  if (!answer || answer->status < 400) return answer;
  Status status = decode_problem(answer->body);
  if (status.code == Code::malformed && answer->status != 400) {
    status = failure(Code::internal, fmt::format("The server answered {}.", answer->status));
  }
  return with_next(std::move(status), advice_for(answer->status));
}

Result<HttpAnswer> Session::make_scene(const std::string& address, const std::string& request) {
  auto answer = accepted(connection_.post_json(address, request));
  const bool full = !answer && answer.status().code == Code::conflict && !answer.status().limit.empty();
  if (!full) return answer;  // other conflicts have no `limit`
  return with_next(answer.status(), "remove a scene that is not needed with `pelage rm`");
}

Result<std::string> Session::scene_path() {
  const auto id = scene_id(options_.scene);
  return id ? Result<std::string>("/v1/scenes/" + *id) : id.status();
}

Result<std::string> Session::scene_id(const std::string& wanted) {
  if (could_be_id(wanted)) {
    const auto answer = accepted(connection_.get("/v1/scenes/" + wanted));
    if (answer) return wanted;
    if (answer.status().code != Code::not_found) return answer.status();
  }
  const auto answer = accepted(connection_.get("/v1/scenes"));
  if (!answer) return answer.status();
  const auto scenes = decode_answer<SceneList>(answer->body);
  if (!scenes) return scenes.status();
  std::vector<std::string> ids;
  std::vector<std::string_view> names;
  for (const SceneSummary& scene : scenes->scenes) {
    names.push_back(scene.name);
    if (scene.name == wanted) ids.push_back(scene.id);
  }
  if (ids.size() == 1) return ids.front();
  if (ids.size() > 1)
    return failure(Code::not_found, fmt::format("{} scenes are named \"{}\"; use an id.", ids.size(), wanted));
  return failure(Code::not_found, "There is no scene \"" + wanted + "\".", "", "", nearest_name(wanted, names));
}

ExitCode print_summary(const Session& session, const Result<HttpAnswer>& answer) {
  if (!answer) return report(answer.status());
  if (session.options().json) {
    fmt::print("{}\n", answer->body);
    return done;
  }
  const auto summary = decode_answer<SceneSummary>(answer->body);
  if (!summary) return report(summary.status());
  print(*summary);
  return done;
}

ExitCode print_change(const Session& session, const Result<HttpAnswer>& answer, const std::string& context) {
  if (!answer) return report(answer.status(), context);
  const auto result = decode_answer<CommandAnswer>(answer->body);
  if (!result) return report(result.status());
  if (session.options().json)
    fmt::print("{}\n", answer->body);
  else
    print(*result);
  return done;
}

}  // namespace pelage
