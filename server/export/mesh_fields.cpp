#include "server/export/mesh_fields.h"

#include <algorithm>
#include <cctype>

#include "renderer/coat/slices.h"
#include "renderer/image/image.h"
#include "server/export/corner_mesh.h"
#include "server/export/glb_writer.h"
#include "server/export/shell_texture.h"
#include "server/export/skin_part.h"
#include "server/export/vertex_colours.h"
#include "server/fields/coats.h"

namespace pelage {

namespace {

constexpr int atlas_columns = 4;

/// Returns the shell textures of the tile in rows from the top, at half the finest resolution.
Image atlas_of(const Coat& coat) {
  const Slices slices = bake_slices(coat);
  const SliceLevel& level = slices.levels[1];
  const auto side = static_cast<std::size_t>(level.texels), width = atlas_columns * side;
  Image atlas{static_cast<int>(width), static_cast<int>(width), std::vector<std::uint8_t>(4 * width * width)};
  for (int k = 0; k < atlas_columns * atlas_columns; ++k) {
    const Image shell = ShellTexture(level, bin_of(k, atlas_columns * atlas_columns)).image();
    const std::size_t left = static_cast<std::size_t>(k % atlas_columns) * side,
                      top = static_cast<std::size_t>(k / atlas_columns) * side;
    for (std::size_t y = 0; y < side; ++y)
      std::copy_n(shell.rgba.begin() + static_cast<std::ptrdiff_t>(4 * y * side), 4 * side,
                  atlas.rgba.begin() + static_cast<std::ptrdiff_t>(4 * ((top + y) * width + left)));
  }
  return atlas;
}

/// Returns of(corner) for each corner.
template <class Value, class Of>
std::vector<Value> of_corners(const CornerMesh& shells, const Of& of) {
  std::vector<Value> values;
  values.reserve(shells.corners.size());
  for (const CornerMesh::Corner& corner : shells.corners) values.push_back(of(corner));
  return values;
}

glm::vec3 lean_vector(const SceneView& scene, std::uint32_t v) {
  const Mesh& mesh = scene.model.surface.mesh();
  const glm::vec4 direction = scene.fields.value(Field::direction, v);
  return direction.x * mesh.tangents[v] + direction.y * glm::cross(mesh.normals[v], mesh.tangents[v]);
}

std::string attribute_of(Field field) {
  std::string name = "_";
  for (const char c : std::string_view(shape_of(field).name))
    name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

/// Adds every scalar field to the attributes.
void add_fields(const SceneView& scene, const CornerMesh& shells, GlbWriter& file, GltfJson& attributes) {
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (shape_of(field).channels != 1) continue;
    const float unit = field == Field::length ? static_cast<float>(scene.model.surface.mesh().size) : 1;
    const auto values = of_corners<float>(
        shells, [&](const CornerMesh::Corner& c) { return unit * scene.fields.number(field, c.vertex); });
    attributes[attribute_of(field)] = file.add(std::span(values));
  }
}

}  // namespace

Result<MeshFile> export_mesh(const SceneView& scene, const ExportedStrands& strands) {
  const Mesh& mesh = scene.model.surface.mesh();
  const CornerMesh shells = make_corner_mesh(scene, true);
  const VertexColours colours(scene.model.surface, strands, 0);
  const std::vector<glm::vec3> vertex_positions = positions_at(scene, 0);
  GlbWriter file;
  const auto positions =
      of_corners<glm::vec3>(shells, [&](const CornerMesh::Corner& c) { return vertex_positions[c.vertex]; });
  const auto normals =
      of_corners<glm::vec3>(shells, [&](const CornerMesh::Corner& c) { return mesh.normals[c.vertex]; });
  const auto uvs = of_corners<glm::vec2>(shells, [&](const CornerMesh::Corner& c) {
    return c.tile_uv / static_cast<float>(first_unmuted(scene.settings.coats).coat.tile);
  });
  const auto fur = of_corners<glm::vec4>(
      shells, [&](const CornerMesh::Corner& c) { return glm::vec4(glm::min(colours.at(c.vertex, 0.7), 1.0f), 1); });
  const auto leans =
      of_corners<glm::vec3>(shells, [&](const CornerMesh::Corner& c) { return lean_vector(scene, c.vertex); });
  const auto weights = of_corners<float>(shells, [](const CornerMesh::Corner& c) { return c.weight; });
  GltfJson attributes = {{"POSITION", file.add_positions(positions)}, {"NORMAL", file.add(std::span(normals))},
                         {"TEXCOORD_0", file.add(std::span(uvs))},    {"COLOR_0", file.add(std::span(fur))},
                         {"_DIRECTION", file.add(std::span(leans))},  {"_WEIGHT", file.add(std::span(weights))}};
  add_fields(scene, shells, file, attributes);
  const int triangles = file.add_triangles(shells.triangles, shells.corners.size());
  const int atlas = file.add_png(encode_png(atlas_of(first_unmuted(scene.settings.coats).coat), true));
  const GltfJson skin = {{"attributes", attributes}, {"indices", triangles}, {"material", 0}};
  const GltfJson extras = {{"fur_layers", atlas_columns * atlas_columns}, {"atlas_columns", atlas_columns}};
  file.set_scene(node_of("skin", 0, strands.transform), GltfJson::array({skin}), extras);
  GltfJson material = material_of("skin", dull);
  material["occlusionTexture"] = {{"index", 0}, {"strength", 0}};
  file.set("materials", GltfJson::array({material}));
  file.set("textures", GltfJson::array({{{"source", atlas}}}));
  Result<std::string> glb = file.finish();
  if (!glb) return glb.status();
  return MeshFile{std::move(*glb), shells.triangles.size()};
}

}  // namespace pelage
