#include "server/export/skin_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/export/corner_mesh.h"

namespace pelage {

float light_at(const Slices& slices, double height) {
  constexpr float deepest_light = 0.35f;  // that reaches the skin
  constexpr float shade = 0.08f;          // light that a strand above takes
  const auto slice = std::min(static_cast<std::size_t>(height * slice_count), std::size_t{slice_count - 1});
  return deepest_light + (1 - deepest_light) * std::exp(-shade * slices.depth_above[slice]);
}

std::string add_skin(GlbWriter& file, const SceneView& scene, const VertexColours& colours, const Slices& slices,
                     int material) {
  const Mesh& mesh = scene.model.surface.mesh();
  std::vector<glm::vec4> lit;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) lit.emplace_back(light_at(slices, 0) * colours.at(v, 0), 1);
  return fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"COLOR_0":{}}},"indices":{},"material":{}}})",
                     file.add_positions(places_at(scene, 0)), file.add(std::span(mesh.normals)),
                     file.add(std::span(std::as_const(lit))), file.add_triangles(mesh.triangles, mesh.positions.size()),
                     material);
}

}  // namespace pelage
