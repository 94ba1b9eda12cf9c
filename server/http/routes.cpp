#include "server/http/routes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/limits.h"
#include "protocol/json/author.h"
#include "protocol/json/reader.h"
#include "server/http/reply.h"

namespace pelage {

void with_scene(Service& service, const httplib::Request& request, httplib::Response& response,
                const std::function<void(const std::shared_ptr<Scene>&)>& use) {
  const auto scene = service.scenes.find(request.matches[1].str());
  if (!scene) return reply_problem(response, scene.status());
  use(*scene);
}

Cancel cancel_of(const ClientSocket& client) {
  return Cancel([&client] { return client.gone(); });
}

void run_once(Service& service, const httplib::Request& request, httplib::Response& response,
              const std::function<void(const RequestedChange&)>& again, const std::function<void()>& run) {
  service.idempotency.answer(request, response, [&] {
    const std::optional<KeyedRequest> keyed = keyed_request_of(request);
    if (!keyed) return run();
    const auto before = service.scenes.change_of_request(*keyed);
    if (!before) return reply_problem(response, before.status());
    if (!*before) return run();
    if ((*before)->fingerprint != keyed->fingerprint) return reply_problem(response, key_reuse_refusal());
    again(**before);
  });
}

std::uint64_t model_id_of(const Scene& scene) { return scene.snapshot()->view().copy_id; }

void add_post(httplib::Server& server, const std::string& pattern, const httplib::Server::Handler& handler,
              std::size_t max_bytes) {
  server.Post(pattern, [handler, max_bytes](const httplib::Request& request, httplib::Response& response) {
    if (request.body.size() <= max_bytes) return handler(request, response);
    reply_problem(response, failure(Code::too_large, fmt::format("The body has {} bytes.", request.body.size()), "",
                                    fmt::format("at most {} bytes", max_bytes)));
  });
}

Query query_of(const httplib::Request& request) { return {request.params.begin(), request.params.end()}; }

Status check_query(const httplib::Request& request, const std::vector<std::string_view>& known) {
  for (const auto& [name, value] : request.params) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      return failure(Code::invalid, "There is no parameter of that name.", "/" + name, "", nearest_name(name, known));
    }
    if (request.params.count(name) > 1) {
      return failure(Code::malformed, "The parameter \"" + name + "\" is given twice.", "/" + name, "each name once");
    }
  }
  return {};
}

Result<ExecuteOptions> change_options_of(const httplib::Request& request) {
  const auto if_match = if_match_of(request);
  if (!if_match) return if_match.status();
  // get_header_value would cut the value at a null character. cpp-httplib has decoded the %XX.
  const auto [author, end] = request.headers.equal_range(author_header);
  if (author == end) return ExecuteOptions{.if_match = *if_match, .request = keyed_request_of(request)};
  if (std::distance(author, end) > 1)
    return failure(Code::malformed, "There is more than one Pelage-Author.", "", "one");
  if (Status bad = check_author(author->second); !bad.ok()) return bad;
  return ExecuteOptions{.if_match = *if_match, .author = author->second, .request = keyed_request_of(request)};
}

namespace {

bool is_file_in(std::string_view folder, std::string_view path) {
  return path.starts_with(folder) && path.size() > folder.size() && path.find('/', folder.size()) == path.npos;
}

/// Returns the part of the template after the scene's id, with {field} or {format} in the place of a name.
std::string route_in_scene(const std::string& path_in_scene) {
  for (const auto& [folder, route] : {std::pair<std::string_view, const char*>{"/maps/", "/maps/{field}"},
                                      std::pair<std::string_view, const char*>{"/export/", "/export/{format}"}}) {
    const bool one =
        path_in_scene.size() > folder.size() && path_in_scene.find('/', folder.size()) == path_in_scene.npos;
    if (one && path_in_scene.starts_with(folder)) return route;
  }
  return path_in_scene;
}

}  // namespace

RouteInfo route_of(const std::string& path) {
  static const auto known = std::to_array<RouteInfo>({{"/v1/scenes", "GET, HEAD, POST"},
                                                      {"/v1/scenes/{id}", "GET, HEAD, DELETE"},
                                                      {"/v1/scenes/{id}/model", "PUT"},
                                                      {"/v1/scenes/{id}/mesh", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/vertices", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/subdivide", "POST"},
                                                      {"/v1/scenes/{id}/turn", "POST"},
                                                      {"/v1/scenes/{id}/rename", "POST"},
                                                      {"/v1/scenes/{id}/environment", "PUT"},
                                                      {"/v1/scenes/{id}/skin_texture", "PUT"},
                                                      {"/v1/scenes/{id}/pictures", "PUT"},
                                                      {"/v1/scenes/{id}/maps/{field}", "GET, HEAD, PUT"},
                                                      {"/v1/scenes/{id}/guides", "PUT"},
                                                      {"/v1/scenes/{id}/commands", "POST"},
                                                      {"/v1/scenes/{id}/undo", "POST"},
                                                      {"/v1/scenes/{id}/redo", "POST"},
                                                      {"/v1/scenes/{id}/revert", "POST"},
                                                      {"/v1/scenes/{id}/amend", "POST"},
                                                      {"/v1/scenes/{id}/branch", "POST"},
                                                      {"/v1/open", "POST"},
                                                      {"/v1/scenes/{id}/export/{format}", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/log", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/events", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/settings", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/compare", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/frames", "GET, HEAD, POST"},
                                                      {"/v1/scenes/{id}/frame.png", "GET, HEAD"},
                                                      {"/v1/scenes/{id}/pick", "POST"},
                                                      {"/v1/scenes/{id}/recipe", "POST"},
                                                      {"/livez", "GET, HEAD"},
                                                      {"/readyz", "GET, HEAD"},
                                                      {"/metrics", "GET, HEAD"},
                                                      {"/openapi.json", "GET, HEAD"}});
  static constexpr std::string_view scenes = "/v1/scenes/";
  if (path == "/") return {"/", "GET, HEAD"};
  if (path == "/docs" || path == "/docs/") return {"/docs", "GET, HEAD"};
  if (is_file_in("/assets/", path)) return {"/assets/{name}", "GET, HEAD"};
  if (is_file_in("/docs/", path)) return {"/docs/{name}", "GET, HEAD"};
  std::string route = path;
  if (path.starts_with(scenes) && path.size() > scenes.size()) {
    const std::size_t end = std::min(path.find('/', scenes.size()), path.size());
    if (end > scenes.size()) route = std::string(scenes) + "{id}" + route_in_scene(path.substr(end));
  }
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const RouteInfo& info) { return info.path == route; });
  return found == known.end() ? RouteInfo{"other", ""} : *found;
}

}  // namespace pelage
