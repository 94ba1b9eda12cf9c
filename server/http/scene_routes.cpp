#include <cstddef>
#include <span>

#include "protocol/base/limits.h"
#include "protocol/json/encode.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

std::uint64_t model_id_of(const Scene& scene) {
  std::uint64_t id = 0;
  scene.read([&](const SceneView& view) { id = view.model.id; });
  return id;
}

void create_scene(Service& service, const Request& request, Response& response) {
  const auto wanted = decode_new_scene(request.body);
  if (!wanted) return reply_problem(response, wanted.status());
  const auto scene = service.scenes.create(*wanted);
  if (!scene) return reply_problem(response, scene.status());
  const SceneSummary summary = (*scene)->summary();
  reply_json(response, 201, encode(summary), summary.revision);
  response.set_header("Location", "/v1/scenes/" + summary.id);
}

void describe_scene(const Scene& scene, const Request& request, Response& response) {
  const SceneSummary summary = scene.summary();
  if (none_match_names(request, summary.revision)) {
    response.status = 304;
    return set_etag(response, summary.revision);
  }
  reply_json(response, 200, encode(summary), summary.revision);
}

void remove_scene(Service& service, const Scene& scene, Response& response) {
  const std::uint64_t model = model_id_of(scene);
  const Status removed = service.scenes.remove(scene.id());
  if (!removed.ok()) return reply_problem(response, removed);
  service.frames.forget(model);
  response.status = 204;
}

void load_model(Service& service, Scene& scene, const Request& request, Response& response, const std::string& octets) {
  const auto options = decode_import_query(query_of(request));
  if (!options) return reply_problem(response, options.status());
  const auto if_match = if_match_of(request);
  if (!if_match) return reply_problem(response, if_match.status());
  const std::uint64_t old_model = model_id_of(scene);
  const auto bytes = std::as_bytes(std::span(octets.data(), octets.size()));
  const auto summary = service.scenes.load_model(scene, *options, bytes, {.if_match = *if_match});
  if (!summary) return reply_problem(response, summary.status());
  service.frames.forget(old_model);
  reply_json(response, 200, encode(*summary), summary->revision);
}

/// The body is read only once there is room for it.
void upload(Service& service, const Request& request, Response& response, const httplib::ContentReader& read) {
  const auto pass = service.uploads.enter();
  if (!pass) {
    reply_problem(response, failure(Code::unavailable, "Other models are being read.", "", "4 at a time"));
    return close_after(response);
  }
  std::string octets;
  const bool whole = read([&](const char* data, std::size_t size) {
    octets.append(data, size);
    return octets.size() <= limits::model_bytes;
  });
  if (!whole) {
    reply_problem(response, failure(Code::malformed, "The body ended before its Content-Length."));
    return close_after(response);
  }
  with_scene(service, request, response,
             [&](const auto& scene) { load_model(service, *scene, request, response, octets); });
}

}  // namespace

void add_scene_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes",
             [&](const Request&, Response& response) { reply_json(response, 200, encode(service.scenes.list())); });
  add_post(server, "/v1/scenes", [&](const Request& request, Response& response) {
    service.idempotency.answer(request, response, [&] { create_scene(service, request, response); });
  });
  server.Get("/v1/scenes/([^/]+)", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { describe_scene(*scene, request, response); });
  });
  server.Delete("/v1/scenes/([^/]+)", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { remove_scene(service, *scene, response); });
  });
  server.Put("/v1/scenes/([^/]+)/model",
             [&](const Request& request, Response& response, const httplib::ContentReader& read) {
               upload(service, request, response, read);
             });
}

}  // namespace pelage
