#include "protocol/json/encode.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

void reply_created(httplib::Response& response, const Result<std::shared_ptr<Scene>>& scene) {
  if (!scene) return reply_problem(response, scene.status());
  const SceneSummary summary = (*scene)->summary();
  reply_json(response, 201, encode(summary), summary.revision);
  response.set_header("Location", "/v1/scenes/" + summary.id);
}

namespace {

using httplib::Request;
using httplib::Response;

void create_scene(Service& service, const Request& request, Response& response) {
  const auto wanted = decode_new_scene(request.body);
  if (!wanted) return reply_problem(response, wanted.status());
  reply_created(response, service.scenes.create(*wanted, keyed_request_of(request)));
}

void branch_scene(Service& service, const Scene& scene, const Request& request, Response& response) {
  const auto wanted = decode_branch(request.body);
  if (!wanted) return reply_problem(response, wanted.status());
  reply_created(response, service.scenes.branch(scene, *wanted, keyed_request_of(request)));
}

void describe_scene(const Scene& scene, const Request& request, Response& response) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const SceneSummary summary = scene.summary();
  if (if_none_match_lists(request, summary.revision)) {
    response.status = 304;
    return set_etag(response, summary.revision);
  }
  reply_json(response, 200, encode(summary), summary.revision);
}

void read_settings(const Scene& scene, const Request& request, Response& response) {
  const auto revision = decode_revision_query(query_of(request));
  if (!revision) return reply_problem(response, revision.status());
  const auto settings = scene.settings(*revision);
  if (!settings) return reply_problem(response, settings.status());
  if (if_none_match_lists(request, settings->revision)) {
    response.status = 304;
    return set_etag(response, settings->revision);
  }
  reply_json(response, 200, encode(*settings), settings->revision);
}

void remove_scene(Service& service, const Request& request, Response& response) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const Status removed = service.scenes.remove(request.matches[1].str());
  if (!removed.ok()) return reply_problem(response, removed);
  response.status = 204;
}

void compare_revisions(const Scene& scene, const Request& request, Response& response) {
  const auto revisions = decode_compare_query(query_of(request));
  if (!revisions) return reply_problem(response, revisions.status());
  const Result<Comparison> comparison = scene.compare(revisions->first, revisions->second);
  if (!comparison) return reply_problem(response, comparison.status());
  reply_json(response, 200, encode(*comparison));
}

}  // namespace

void add_scene_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes", [&](const Request& request, Response& response) {
    if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
    reply_json(response, 200, encode(SceneList{service.scenes.list()}));
  });
  const auto create_once = [&service](const Request& request, Response& response, const std::function<void()>& create) {
    run_once(
        service, request, response,
        [&](const RequestedChange& made) { reply_created(response, service.scenes.find(made.scene)); }, create);
  };
  add_post(server, "/v1/scenes", [&service, create_once](const Request& request, Response& response) {
    create_once(request, response, [&] { create_scene(service, request, response); });
  });
  add_post(server, "/v1/scenes/([^/]+)/branch", [&service, create_once](const Request& request, Response& response) {
    create_once(request, response, [&] {
      with_scene(service, request, response,
                 [&](const auto& scene) { branch_scene(service, *scene, request, response); });
    });
  });
  server.Get("/v1/scenes/([^/]+)", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { describe_scene(*scene, request, response); });
  });
  server.Get("/v1/scenes/([^/]+)/settings", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { read_settings(*scene, request, response); });
  });
  server.Get("/v1/scenes/([^/]+)/compare", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { compare_revisions(*scene, request, response); });
  });
  server.Delete("/v1/scenes/([^/]+)",
                [&](const Request& request, Response& response) { remove_scene(service, request, response); });
}

}  // namespace pelage
