#include "server/export/skin_part.h"

#include <algorithm>
#include <cmath>

#include "server/export/corner_mesh.h"

namespace pelage {

float light_at(const Slices& slices, double height) {
  constexpr float deepest_light = 0.35f;  // share of the light under infinitely dense fur
  constexpr float shade = 0.08f;          // extinction per strand above
  const auto slice = std::min(static_cast<std::size_t>(height * slice_count), std::size_t{slice_count - 1});
  return deepest_light + (1 - deepest_light) * std::exp(-shade * slices.depth_above[slice]);
}

GltfJson add_skin(GlbWriter& file, const SceneView& scene, const VertexColours& colours, const Slices& slices,
                  int material) {
  const Mesh& mesh = scene.model.surface.mesh();
  std::vector<glm::vec4> lit;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) lit.emplace_back(light_at(slices, 0) * colours.at(v, 0), 1);
  return {{"attributes",
           {{"POSITION", file.add_positions(positions_at(scene, 0))},
            {"NORMAL", file.add(std::span(mesh.normals))},
            {"COLOR_0", file.add(std::span(std::as_const(lit)))}}},
          {"indices", file.add_triangles(mesh.triangles, mesh.positions.size())},
          {"material", material}};
}

GltfJson node_of(const std::string& name, std::size_t mesh, const FileTransform& transform) {
  return node_of(name, mesh, transform.metres * transform.centre, transform.turn, transform.metres);
}

GltfJson material_of(const std::string& name, double roughness) {
  return {{"name", name}, {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
}

}  // namespace pelage
