#include "clients/cli/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <thread>
#include <utility>

#include "clients/cli/pack/pack.h"
#include "clients/cli/print.h"
#include "protocol/base/limits.h"
#include "protocol/base/percent.h"
#include "protocol/base/stopwatch.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

ExitCode perform(Session& session) {
  switch (session.options().action) {
    case Action::wait: return wait_for_server(session);
    case Action::create: return create_scene(session);
    case Action::load: return load_model(session);
    case Action::environment: return load_environment(session);
    case Action::skin_texture: return load_skin_texture(session);
    case Action::get_map: return get_map(session);
    case Action::put_map: return put_map(session);
    case Action::put_picture: return put_picture(session);
    case Action::run: return run_file(session);
    case Action::frame: return draw_frame(session);
    case Action::export_fur: return export_fur(session);
    case Action::open_saved: return open_saved(session);
    case Action::undo:
    case Action::redo:
    case Action::revert: return move_in_history(session);
    case Action::amend: return amend_step(session);
    case Action::branch: return branch_scene(session);
    case Action::log: return show_log(session);
    case Action::pick: return pick_pixel(session);
    case Action::list: return list_scenes(session);
    case Action::remove: return remove_scene(session);
    case Action::info: return describe_scene(session);
    case Action::subdivide: return subdivide_model(session);
    case Action::compare:
    case Action::trade:
    case Action::calibrate: break;  // need no session: pelage-compare, pelage-trade and pelaged do them
  }
  return failed;
}

namespace {

std::string new_scene_request_of(const Options& options) {
  const std::string form = options.form.empty() ? "" : ",\"form\":" + json_text(options.form);
  return fmt::format(
      R"({{"name":{},"model":{{"builtin":{},"triangles":{}}},"fur":{{"length":{},"inclination":{}{}}},"fur_patches":{}}})",
      json_text(options.name), json_text(options.builtin), options.triangles, options.length, options.inclination, form,
      json_text(options.fur_patches));
}

/// "obj" of "spot.OBJ".
std::string ending_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// `format` as it is sent.
Query import_query(const Options& options, const std::string& format) {
  Query query{{"format", format},
              {"length", fmt::format("{}", options.length)},
              {"inclination", fmt::format("{}", options.inclination)},
              {"fur_patches", options.fur_patches}};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) query.emplace_back(name, value);
  };
  add("up", options.up), add("front", options.front), add("pose", options.pose), add("form", options.form);
  add("crease_degrees", options.crease_degrees), add("flip", fmt::format("{}", fmt::join(options.flip, ",")));
  add("two_sided", fmt::format("{}", fmt::join(options.two_sided, ",")));
  return query;
}

/// Sends bytes to `name` of the scene.
Result<HttpAnswer> put_bytes(Session& session, const std::string& scene_path, const char* name, const Query& query,
                             const std::string& bytes) {
  std::string address = scene_path + "/" + name;
  char separator = '?';
  for (const auto& [parameter, value] : query)
    address += std::exchange(separator, '&') + parameter + "=" + percent_encoded(value);
  return Session::accepted(session.connection().put_bytes(address, bytes));
}

Result<HttpAnswer> put_file(Session& session, const char* name, const Query& query, std::size_t max_bytes) {
  const auto bytes = read_file(session.options().file, max_bytes);
  if (!bytes) return bytes.status();
  const auto path = session.scene_path();
  return path ? put_bytes(session, *path, name, query, *bytes) : path.status();
}

/// The model with what it names; standard input is sent as it is.
Result<PackedModel> packed(const Options& options, const std::string& format) {
  if (options.file != "-") {
    auto model = pack_model(options.file, format, limits::model_bytes);
    if (model || model.status().code != Code::not_found) return model;
  }
  const auto bytes = read_file(options.file, limits::model_bytes);
  if (!bytes) return bytes.status();
  return PackedModel{*bytes, false, {}};
}

/// What to do about a model that was refused. `pose` as it was asked for.
std::string next_after(const Status& status, const PackedModel& model, const std::string& pose) {
  const auto says = [&](const std::string& word) { return status.message.find(word) != std::string::npos; };
  for (const std::string& file : model.missing)
    if (says(file)) return "put " + file + " beside the model and load it again; the scene is as it was";
  if (!pose.empty() && (says("animation") || says("pose")))
    return "load it again with another --pose or without; the scene is as it was";
  return "mend or convert the file and load it again; the scene is as it was";
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

}  // namespace

ExitCode wait_for_server(Session& session) {
  constexpr std::chrono::milliseconds pause(200);
  const Stopwatch passed;
  auto answer = Session::accepted(session.connection().get("/readyz"));
  while (!answer && passed.milliseconds() < 1e3 * session.options().wait_seconds) {
    std::this_thread::sleep_for(pause);
    answer = Session::accepted(session.connection().get("/readyz"));
  }
  return answer ? done : report(answer.status());
}

namespace {

/// Of the options' file, with a next step that fits it.
Result<HttpAnswer> load_into(Session& session, const std::string& scene_path) {
  const Options& options = session.options();
  const std::string format = options.format.empty() ? ending_of(options.file) : options.format;
  if (const auto checked = decode_import_query(import_query(options, format)); !checked) return checked.status();
  const auto model = packed(options, format);
  if (!model) return model.status();
  const Query query = import_query(options, model->is_zip ? "zip" : format);
  auto answer = put_bytes(session, scene_path, "model", query, model->bytes);
  if (answer) return answer;
  const Status& status = answer.status();
  const bool about_the_file = status.code == Code::invalid && status.pointer.empty();
  return about_the_file ? with_next(status, next_after(status, *model, options.pose)) : status;
}

/// A scene whose model cannot be loaded goes again.
ExitCode fill_new_scene(Session& session, const std::string& id) {
  const std::string path = "/v1/scenes/" + id;
  const Result<HttpAnswer> answer = load_into(session, path);
  if (!answer) {
    static_cast<void>(session.connection().remove(path));  // the load's own failure is the one to tell
    return report(answer.status(), session.options().file);
  }
  fmt::print("{}\n", session.options().json ? answer->body : id);
  return done;
}

}  // namespace

ExitCode create_scene(Session& session) {
  const std::string request = new_scene_request_of(session.options());
  if (const auto checked = decode_new_scene(request); !checked) return report(checked.status());
  const auto answer = session.make_scene("/v1/scenes", request);
  if (!answer) return report(answer.status());
  const auto summary = decode_answer<SceneSummary>(answer->body);
  if (!summary) return report(summary.status());
  if (!session.options().file.empty()) return fill_new_scene(session, summary->id);
  fmt::print("{}\n", session.options().json ? answer->body : summary->id);
  return done;
}

ExitCode load_model(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const Result<HttpAnswer> answer = load_into(session, *path);
  return answer ? print_summary(session, answer) : report(answer.status(), session.options().file);
}

ExitCode load_environment(Session& session) {
  const Options& options = session.options();
  const Query query = {{"intensity", fmt::format("{}", options.intensity)},
                       {"turn_degrees", fmt::format("{}", options.turn_degrees)}};
  if (const auto checked = decode_environment_query(query); !checked) return report(checked.status());
  return print_change(session, put_file(session, "environment", query, limits::picture_bytes), session.options().file);
}

ExitCode load_skin_texture(Session& session) {
  return print_change(session, put_file(session, "skin_texture", {}, limits::picture_bytes), session.options().file);
}

ExitCode list_scenes(Session& session) {
  const auto answer = Session::accepted(session.connection().get("/v1/scenes"));
  if (!answer) return report(answer.status());
  const auto scenes = decode_answer<SceneList>(answer->body);
  if (!scenes) return report(scenes.status());
  if (session.options().json)
    fmt::print("{}\n", answer->body);
  else
    print(scenes->scenes);
  return done;
}

ExitCode describe_scene(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return print_summary(session, Session::accepted(session.connection().get(*path)));
}

ExitCode subdivide_model(Session& session) {
  const Options& options = session.options();
  const std::string body = fmt::format(R"({{"levels":{},"masked":{}}})", options.levels, options.masked);
  if (const auto checked = decode_subdivide(body); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return print_summary(session, Session::accepted(session.connection().post_json(*path + "/subdivide", body)));
}

ExitCode remove_scene(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().remove(*path));
  return answer ? done : report(answer.status());
}

}  // namespace pelage
