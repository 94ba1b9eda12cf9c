#include "protocol/json/decode.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

void send_file(const MeshCache::File& file, Response& response) {
  response.set_content_provider(file->size(), "model/gltf-binary",
                                [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(file->data() + offset, length);
                                });
}

void get_mesh(Service& service, const Scene& scene, const Request& request, Response& response) {
  const auto wanted = decode_mesh_query(query_of(request));
  if (!wanted) return reply_problem(response, wanted.status());
  const std::shared_ptr<const SceneModel> model = scene.model();
  const std::string etag = service.meshes.etag_of(*model, wanted->triangles);
  if (!none_match_names(request, etag)) {
    const Result<MeshCache::File> file = service.meshes.mesh(model, wanted->triangles);
    if (!file) return reply_problem(response, file.status());
    send_file(*file, response);
    response.status = 200;
  } else {
    response.status = 304;
  }
  response.set_header("ETag", etag);
  response.set_header("Cache-Control", "no-cache");
}

}  // namespace

void add_mesh_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes/([^/]+)/mesh", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { get_mesh(service, *scene, request, response); });
  });
}

}  // namespace pelage
