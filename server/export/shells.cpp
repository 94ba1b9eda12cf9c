#include "server/export/shells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "renderer/coat/slices.h"
#include "renderer/image/image.h"
#include "server/export/corner_mesh.h"
#include "server/export/eye_part.h"
#include "server/export/glb_writer.h"
#include "server/export/shell_texture.h"
#include "server/export/skin_part.h"
#include "server/export/vertex_colours.h"
#include "server/fields/coats.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

/// The data that all shells share, and the members of the file that grow with each shell.
class ShellFile {
 public:
  ShellFile(const SceneView& scene, const FileTransform& transform, const CornerMesh& shells,
            const VertexColours& colours, const Slices& slices)
      : scene_(scene), transform_(transform), shells_(shells), colours_(colours), slices_(slices) {
    if (shells.triangles.empty()) return;  // glTF has no empty arrays
    const Mesh& mesh = scene.model.surface.mesh();
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    for (const CornerMesh::Corner& corner : shells.corners) {
      normals.push_back(mesh.normals[corner.vertex]);
      uvs.push_back(corner.tile_uv / static_cast<float>(first_unmuted(scene.settings.coats).coat.tile));
    }
    normals_ = file_.add(std::span(std::as_const(normals))), uvs_ = file_.add(std::span(std::as_const(uvs)));
    triangles_ = file_.add_triangles(shells.triangles, shells.corners.size());
  }

  void add_skin() {
    primitives_.push_back(pelage::add_skin(file_, scene_, colours_, slices_, 0));
    materials_.push_back(material_of("skin", dull));
  }

  void add_eyes(const std::vector<FurEye>& eyes, int material) {
    if (eyes.empty()) return;
    primitives_.push_back(pelage::add_eyes(file_, eyes, scene_.model.surface.mesh().size, material));
    materials_.push_back(material_of("eyes", wet));
  }

  void add_shell(int shell, int shell_count, const std::string& texture) {
    const SliceBin bin = bin_of(shell, shell_count);
    const std::vector<glm::vec3> vertex_positions = positions_at(scene_, bin.height);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> colours;
    for (const CornerMesh::Corner& corner : shells_.corners) {
      positions.push_back(vertex_positions[corner.vertex]);
      const glm::vec3 lit =
          ShellTexture::headroom * light_at(slices_, bin.height) * colours_.at(corner.vertex, bin.height);
      const float density = scene_.fields.number(Field::density, corner.vertex);
      colours.emplace_back(glm::min(lit, 1.0f), corner.weight * density);
    }
    const int image = file_.add_png(texture);
    textures_.push_back({{"source", image}, {"sampler", 0}});
    GltfJson& material = materials_.emplace_back(material_of(fmt::format("fur {}", shell + 1), 0.9));
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", image}};
    primitives_.push_back({{"attributes",
                            {{"POSITION", file_.add_positions(positions)},
                             {"NORMAL", normals_},
                             {"TEXCOORD_0", uvs_},
                             {"COLOR_0", file_.add(std::span(std::as_const(colours)))}}},
                           {"indices", triangles_},
                           {"material", shell + 1}});
  }

  Result<std::string> finish() {
    file_.set_scene(node_of("fur", 0, transform_), primitives_);
    file_.set("materials", materials_);
    if (textures_.empty()) return file_.finish();
    file_.set("textures", textures_);
    file_.set_sampler(repeated);
    return file_.finish();
  }

 private:
  const SceneView& scene_;
  const FileTransform& transform_;
  const CornerMesh& shells_;
  const VertexColours& colours_;
  const Slices& slices_;
  GlbWriter file_;
  int normals_ = 0, uvs_ = 0, triangles_ = 0;
  GltfJson primitives_ = GltfJson::array(), materials_ = GltfJson::array(), textures_ = GltfJson::array();
};

/// Returns the texture of each shell as PNG. Works in parallel, since the compression takes longer than all the rest.
std::vector<std::string> shell_textures(const Slices& slices, int shell_count) {
  std::vector<std::string> textures(static_cast<std::size_t>(shell_count));
  for_each_in_parallel(static_cast<std::uint32_t>(shell_count), [&](std::uint32_t shell) {
    const SliceBin bin = bin_of(static_cast<int>(shell), shell_count);
    textures[shell] = encode_png(ShellTexture(slices.levels.front(), bin).image(), true);
  });
  return textures;
}

}  // namespace

Result<BakedShells> bake_shells(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request) {
  const CornerMesh shells = make_corner_mesh(scene);
  const VertexColours colours(scene.model.surface, strands);
  const Slices slices = bake_slices(first_unmuted(scene.settings.coats).coat);
  ShellFile file(scene, strands.transform, shells, colours, slices);
  file.add_skin();
  const int shell_count = shells.triangles.empty() ? 0 : request.shells;
  const std::vector<std::string> textures = shell_textures(slices, shell_count);
  for (int shell = 0; shell < shell_count; ++shell)
    file.add_shell(shell, shell_count, textures[static_cast<std::size_t>(shell)]);
  file.add_eyes(make_frame(scene, FrameRequest{}).eyes, shell_count + 1);
  Result<std::string> glb = file.finish();
  if (!glb) return glb.status();
  return BakedShells{std::move(*glb), scene.model.surface.mesh().triangles.size() +
                                          static_cast<std::uint64_t>(shell_count) * shells.triangles.size()};
}

}  // namespace pelage
