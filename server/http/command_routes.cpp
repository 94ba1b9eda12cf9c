#include "protocol/json/encode.h"
#include "server/http/guard.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

Result<ExecuteOptions> options_of(const Request& request, const std::vector<std::string_view>& parameters) {
  Result<ExecuteOptions> options = change_options_of(request);
  if (!options) return options;
  if (Status status = check_query(request, parameters); !status.ok()) return status;
  const Result<bool> dry_run = is_dry_run(request);
  if (!dry_run) {
    return dry_run.status();
  }
  options->dry_run = *dry_run;
  return options;
}

void reply_answer(Response& response, const Result<CommandAnswer>& answer) {
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer), answer->revision);
}

void run_commands(Service& service, Scene& scene, const Request& request, Response& response) {
  auto options = options_of(request, {"dry_run"});
  if (!options) return reply_problem(response, options.status());
  const ClientSocket client(request);
  options->cancel = cancel_of(client);
  const auto commands = decode_commands(request.body);
  if (!commands) return reply_problem(response, commands.status());
  reply_answer(response, service.scenes.execute(scene, *commands, *options));
}

/// Replaces the scene's model by a changed one, for example a subdivided one, by `change(how, options)`.
template <class How, class Change>
void change_model(Service& service, Scene& scene, const Request& request, Response& response, const Result<How>& how,
                  const Change& change) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const auto if_match = if_match_of(request);
  if (!if_match) return reply_problem(response, if_match.status());
  if (!how) return reply_problem(response, how.status());
  const std::uint64_t old_model = model_id_of(scene);
  const ClientSocket client(request);
  const ExecuteOptions options{
      .if_match = *if_match, .cancel = cancel_of(client), .request = keyed_request_of(request)};
  const Result<SceneSummary> summary = change(*how, options);
  if (!summary) return reply_problem(response, summary.status());
  if (model_id_of(scene) != old_model) service.frames.forget(old_model);
  reply_json(response, 200, encode(*summary), summary->revision);
}

void subdivide(Service& service, Scene& scene, const Request& request, Response& response) {
  change_model(service, scene, request, response, decode_subdivide(request.body),
               [&](const Subdivide& how, const ExecuteOptions& options) {
                 return service.scenes.subdivide(scene, how, options);
               });
}

void turn(Service& service, Scene& scene, const Request& request, Response& response) {
  change_model(
      service, scene, request, response, decode_turn_model(request.body),
      [&](const TurnModel& how, const ExecuteOptions& options) { return service.scenes.turn(scene, how, options); });
}

void rename(Scene& scene, const Request& request, Response& response) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const auto wanted = decode_scene_name(request.body);
  if (!wanted) return reply_problem(response, wanted.status());
  if (Status renamed = scene.rename(wanted->name); !renamed.ok()) return reply_problem(response, renamed);
  const SceneSummary summary = scene.summary();
  reply_json(response, 200, encode(summary), summary.revision);
}

Result<HistoryMove> undo_of(const std::string& body) {
  const auto steps = decode_steps(body);
  if (!steps) return steps.status();
  return HistoryMove(Undo{*steps});
}

Result<HistoryMove> redo_of(const std::string& body) {
  const auto steps = decode_steps(body);
  if (!steps) return steps.status();
  return HistoryMove(Redo{*steps});
}

Result<HistoryMove> revert_of(const std::string& body) {
  const auto revision = decode_revision(body);
  if (!revision) return revision.status();
  return HistoryMove(Revert{*revision});
}

void move(Scene& scene, const Result<HistoryMove>& wanted, const Request& request, Response& response) {
  if (!wanted) return reply_problem(response, wanted.status());
  const auto options = options_of(request, {});
  if (!options) return reply_problem(response, options.status());
  reply_answer(response, scene.move(*wanted, *options));
}

void amend(Service& service, Scene& scene, const Request& request, Response& response) {
  auto options = options_of(request, {"dry_run"});
  if (!options) return reply_problem(response, options.status());
  const ClientSocket client(request);
  options->cancel = cancel_of(client);
  const auto wanted = decode_amend(request.body);
  if (!wanted) return reply_problem(response, wanted.status());
  reply_answer(response, service.scenes.amend(scene, *wanted, *options));
}

/// Returns the commands of each step that lead to the scene's present state. If the parameter "for" names another
/// scene, they are transferred to its model.
Result<std::vector<std::vector<Command>>> lines_of(Service& service, const Scene& scene, const Request& request) {
  if (!request.has_param("for")) return scene.effective_log();
  const auto other = service.scenes.find(request.get_param_value("for"));
  if (!other) return failure(Code::invalid, "There is no such scene to transfer the log to.", "/for");
  return scene.effective_log_for(*(*other)->model());
}

void read_log(Service& service, const Scene& scene, const Request& request, Response& response) {
  const Status status = check_query(request, {"format", "for"});
  if (!status.ok()) return reply_problem(response, status);
  const std::string format = request.has_param("format") ? request.get_param_value("format") : "json";
  if (format == "json" && request.has_param("for"))
    return reply_problem(response, failure(Code::invalid, "Only the format jsonl can be transferred to another scene.",
                                           "/for", "with format jsonl"));
  if (format == "json") return reply_uncompressed(response, "application/json", encode(Log{scene.log()}));
  if (format != "jsonl") {
    return reply_problem(response, failure(Code::invalid, "The log has no such format.", "/format", "json | jsonl"));
  }
  const auto steps = lines_of(service, scene, request);
  if (!steps) return reply_problem(response, steps.status());
  std::string lines;
  for (const std::vector<Command>& step : *steps) lines += encode(step) + "\n";
  reply_uncompressed(response, "application/jsonl", std::move(lines));
}

using SceneHandler = std::function<void(Scene&, const Request&, Response&)>;
using Again = std::function<void(Scene&, const RequestedChange&, Response&)>;

void answer_change(Scene&, const RequestedChange& change, Response& response) {
  reply_answer(response, CommandAnswer{change.revision, change.fields_hash, {}});
}

void answer_scene(Scene& scene, const RequestedChange&, Response& response) {
  const SceneSummary summary = scene.summary();
  reply_json(response, 200, encode(summary), summary.revision);
}

void post(httplib::Server& server, Service& service, const char* name, const SceneHandler& handle,
          const Again& again = answer_change) {
  const std::string pattern = std::string("/v1/scenes/([^/]+)/") + name;
  add_post(server, pattern, [&service, handle, again](const Request& request, Response& response) {
    const YieldGate::Priority turn = service.gate.take_priority();
    const auto use_scene = [&](const auto& use) {
      with_scene(service, request, response, [&](const auto& scene) { use(*scene); });
    };
    run_once(
        service, request, response,
        [&](const RequestedChange& change) { use_scene([&](Scene& scene) { again(scene, change, response); }); },
        [&] { use_scene([&](Scene& scene) { handle(scene, request, response); }); });
  });
}

}  // namespace

void add_command_routes(httplib::Server& server, Service& service) {
  post(server, service, "commands", [&](Scene& scene, const Request& request, Response& response) {
    run_commands(service, scene, request, response);
  });
  post(
      server, service, "subdivide",
      [&](Scene& scene, const Request& request, Response& response) { subdivide(service, scene, request, response); },
      answer_scene);
  post(
      server, service, "turn",
      [&](Scene& scene, const Request& request, Response& response) { turn(service, scene, request, response); },
      answer_scene);
  post(server, service, "rename", rename, answer_scene);
  post(server, service, "undo", [](Scene& scene, const Request& request, Response& response) {
    move(scene, undo_of(request.body), request, response);
  });
  post(server, service, "redo", [](Scene& scene, const Request& request, Response& response) {
    move(scene, redo_of(request.body), request, response);
  });
  post(server, service, "revert", [](Scene& scene, const Request& request, Response& response) {
    move(scene, revert_of(request.body), request, response);
  });
  post(server, service, "amend", [&service](Scene& scene, const Request& request, Response& response) {
    amend(service, scene, request, response);
  });
  server.Get("/v1/scenes/([^/]+)/log", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { read_log(service, *scene, request, response); });
  });
}

}  // namespace pelage
