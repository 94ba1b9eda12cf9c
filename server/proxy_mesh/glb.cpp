#include <fmt/format.h>

#include "server/glb/glb_writer.h"
#include "server/proxy_mesh/proxy_mesh.h"

namespace pelage {

std::string glb_of(const ProxyMesh& mesh) {
  GlbWriter file;
  const int positions = file.add_positions(mesh.positions), normals = file.add(std::span(mesh.normals));
  const int triangles = file.add_triangles(mesh.triangles, mesh.positions.size());
  file.set("scene", "0");
  file.set("scenes", R"([{"nodes":[0]}])");
  file.set("nodes", fmt::format(R"([{{"mesh":0,"translation":{}}}])", json_of(mesh.centre)));
  file.set("meshes", fmt::format(R"([{{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{}}}]}}])",
                                 positions, normals, triangles));
  return std::move(file.finish()).value();  // limits::proxy_triangles take some megabytes
}

}  // namespace pelage
