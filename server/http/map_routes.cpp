#include "base/limits.h"
#include "protocol/json/encode.h"
#include "server/http/reply.h"
#include "server/http/routes.h"
#include "server/scene/map_pictures.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

constexpr int large_side = 4096;  // pixels; larger maps are made one at a time, as large frames are

void reply_map(Service& service, const Scene& scene, const MapRequest& wanted, Response& response) {
  const bool large = wanted.size > large_side;
  const auto pass = large ? service.large_frames.enter() : Gate::Pass(nullptr);
  if (large && !pass) {
    return reply_problem(response,
                         failure(Code::unavailable, "Another large picture is being made.", "", "one at a time"));
  }
  Result<MapFile> map = scene.draw_map(wanted);
  if (!map) return reply_problem(response, map.status());
  response.status = 200;
  set_etag(response, map->answer.revision);
  response.set_header("Pelage-Revision", std::to_string(map->answer.revision));
  response.set_header("Pelage-Map", encode(map->answer));
  response.set_header("Cache-Control", "no-cache");
  response.set_content(map->bytes, map->content_type);
}

void get_map(Service& service, const Scene& scene, const Request& request, Response& response) {
  const auto wanted = decode_map_query(map_query_of(request));
  if (!wanted) return reply_problem(response, not_found_at(wanted.status(), "/field"));
  const Revision revision = scene.revision();
  if (if_none_match_lists(request, revision)) {
    response.status = 304;
    return set_etag(response, revision);
  }
  reply_map(service, scene, *wanted, response);
}

}  // namespace

Query map_query_of(const Request& request) {
  Query query = query_of(request);
  query.emplace_back("field", request.matches[2].str());
  return query;
}

void add_map_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes/([^/]+)/maps/([^/]+)", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { get_map(service, *scene, request, response); });
  });
}

}  // namespace pelage
