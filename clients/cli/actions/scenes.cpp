#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "base/stopwatch.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/actions/models.h"
#include "clients/cli/terminal/print.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

std::string new_scene_request_of(const Options& options) {
  const std::string form = options.form.empty() ? "" : ",\"form\":" + json_text(options.form);
  return fmt::format(
      R"({{"name":{},"model":{{"builtin":{},"triangles":{}}},"fur":{{"length":{},"inclination":{}{}}},"fur_patches":{},"ground":{}}})",
      json_text(options.name), json_text(options.builtin), options.triangles, options.length, options.inclination, form,
      json_text(options.fur_patches), options.ground);
}

/// Loads the model of a new scene, and removes the scene if that fails.
ExitCode fill_new_scene(Session& session, const std::string& id) {
  const std::string path = "/v1/scenes/" + id;
  const Result<HttpAnswer> answer = load_into(session, path);
  if (!answer) {
    static_cast<void>(session.connection().remove(path));  // only the failed load is reported
    return report(answer.status(), session.options().file);
  }
  fmt::print("{}\n", session.options().json ? answer->body : id);
  return done;
}

}  // namespace

ExitCode wait_for_server(Session& session) {
  constexpr std::chrono::milliseconds pause(200);
  const Stopwatch passed;
  const auto answer = with_progress_line("waiting for " + session.options().server, [&] {
    auto ready = Session::accepted(session.connection().get("/readyz"));
    while (!ready && passed.milliseconds() < 1e3 * session.options().wait_seconds) {
      std::this_thread::sleep_for(pause);
      ready = Session::accepted(session.connection().get("/readyz"));
    }
    return ready;
  });
  return answer ? done : report(answer.status());
}

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

ExitCode list_scenes(Session& session) {
  const auto answer = Session::accepted(session.connection().get("/v1/scenes"));
  if (!answer) return report(answer.status());
  const auto scenes = decode_answer<SceneList>(answer->body);
  if (!scenes) return report(scenes.status());
  if (session.options().json)
    fmt::print("{}\n", answer->body);
  else if (session.options().names)
    for (const SceneSummary& scene : scenes->scenes) fmt::print("{}\n", scene.name);
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
  return print_summary(session, with_progress_line("subdividing", [&] {
                         return Session::accepted(session.connection().post_json(*path + "/subdivide", body));
                       }));
}

ExitCode turn_model(Session& session) {
  const Options& options = session.options();
  const std::string up = options.up.empty() ? "y" : options.up, front = options.front.empty() ? "z" : options.front;
  const std::string body = fmt::format(R"({{"up":"{}","front":"{}"}})", up, front);
  if (const auto checked = decode_turn_model(body); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  return print_summary(session, with_progress_line("turning", [&] {
                         return Session::accepted(session.connection().post_json(*path + "/turn", body));
                       }));
}

ExitCode rename_scene(Session& session) {
  const std::string body = fmt::format(R"({{"name":{}}})", json_text(session.options().name));
  if (const auto checked = decode_scene_name(body); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().post_json(*path + "/rename", body));
  if (!answer || session.options().json) return print_summary(session, answer);
  return done;
}

ExitCode remove_scene(Session& session) {
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().remove(*path));
  return answer ? done : report(answer.status());
}

}  // namespace pelage
