// Routes that ask a scene where something is: picks, and recipes, which are made with picks.
#include "protocol/json/encode.h"
#include "protocol/recipes/recipe.h"
#include "server/frames/seen_strand.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

Result<PickAnswer> pick(Service& service, const std::shared_ptr<Scene>& scene, const PickRequest& wanted) {
  if (!asks_for_strand(wanted)) return scene->pick(wanted);
  auto strand = strand_at_pixel(service.frames, scene, wanted.view, wanted.pixel);
  if (!strand) return strand.status();
  auto answer = scene->pick(wanted, *strand ? (*strand)->coat : "");
  if (answer) answer->strand = *strand;
  return answer;
}

void answer_pick(Service& service, const std::shared_ptr<Scene>& scene, const Request& request, Response& response) {
  const auto wanted = decode_pick(request.body);
  const auto answer = wanted ? pick(service, scene, *wanted) : Result<PickAnswer>(wanted.status());
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer));
}

Result<RecipeAnswer> expand(Service& service, const std::shared_ptr<Scene>& scene, const Request& request) {
  const auto wanted = decode_recipe(request.body);
  if (!wanted) return wanted.status();
  const ClientSocket client(request);
  const auto pick_unless_gone = [&](const PickRequest& pick_request) -> Result<PickAnswer> {
    if (client.gone()) return failure(Code::unavailable, "The client has hung up.");
    return pick(service, scene, pick_request);
  };
  const SceneSummary now = scene->summary();
  auto steps = expand_recipe(*wanted, {now.report.bounds, pick_unless_gone});
  if (!steps) return steps.status();
  return RecipeAnswer{now.revision, std::move(*steps)};
}

void answer_recipe(Service& service, const std::shared_ptr<Scene>& scene, const Request& request, Response& response) {
  const auto answer = expand(service, scene, request);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer));
}

}  // namespace

void add_pick_routes(httplib::Server& server, Service& service) {
  add_post(server, "/v1/scenes/([^/]+)/pick", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { answer_pick(service, scene, request, response); });
  });
  const auto recipe = [&](const Request& request, Response& response) {
    with_scene(service, request, response,
               [&](const auto& scene) { answer_recipe(service, scene, request, response); });
  };
  add_post(server, "/v1/scenes/([^/]+)/recipe", recipe, limits::recipe_bytes);
}

}  // namespace pelage
