#include "protocol/json/decode.h"
#include "server/export/proxy_mesh.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

std::string file_of(const ProxyMesh& mesh, const SceneSnapshot& scene, const MeshRequest& wanted) {
  if (!wanted.fur) return glb_of(mesh);
  const ProxyFur fur = fur_on(mesh, scene.model->surface.mesh(), *scene.fields, scene.settings->coats);
  return glb_of(mesh, &fur);
}

void get_mesh(Service& service, const Scene& scene, const Request& request, Response& response) {
  const auto wanted = decode_mesh_query(query_of(request));
  if (!wanted) return reply_problem(response, wanted.status());
  const SnapshotPtr now = scene.snapshot();
  const std::string etag = service.meshes.etag_of(*now, *wanted);
  if (!if_none_match_lists(request, etag)) {
    const Result<MeshCache::MeshPtr> mesh = service.meshes.mesh(now->model, wanted->triangles);
    if (!mesh) return reply_problem(response, mesh.status());
    response.set_content(file_of(**mesh, *now, *wanted), "model/gltf-binary");
    response.status = 200;
  } else {
    response.status = 304;
  }
  response.set_header("ETag", etag);
  response.set_header("Cache-Control", "no-cache");
  response.set_header("Pelage-Revision", std::to_string(now->revision));
}

void get_vertices(const Scene& scene, const Request& request, Response& response) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const SnapshotPtr now = scene.snapshot();
  response.set_content(npy_of_vertices(now->model->surface.mesh()), "application/x-npy");
  response.status = 200;
  response.set_header("Pelage-Revision", std::to_string(now->revision));
}

}  // namespace

void add_mesh_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes/([^/]+)/mesh", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { get_mesh(service, *scene, request, response); });
  });
  server.Get("/v1/scenes/([^/]+)/vertices", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { get_vertices(*scene, request, response); });
  });
}

}  // namespace pelage
