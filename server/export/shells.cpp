#include "server/export/shells.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/parallel.h"
#include "renderer/coat/slices.h"
#include "renderer/image/image.h"
#include "server/export/coat_alone.h"
#include "server/export/corner_mesh.h"
#include "server/export/eye_part.h"
#include "server/export/glb_writer.h"
#include "server/export/shell_texture.h"
#include "server/export/skin_part.h"
#include "server/export/vertex_colours.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

/// A coat and what all of its shells share.
struct ShellCoat {
  const std::string& name;
  const CoatAlone& scene;
  const VertexColours& colours;
  const Slices& slices;
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

/// The members of the file that grow with each part.
class ShellFile {
 public:
  ShellFile(const SceneView& scene, const FileTransform& transform) : scene_(scene), transform_(transform) {}

  void add_skin(const VertexColours& colours, const Slices& slices) {
    primitives_.push_back(pelage::add_skin(file_, scene_, colours, slices, add_material(material_of("skin", dull))));
  }

  void add_eyes(const std::vector<FurEye>& eyes) {
    if (eyes.empty()) return;
    const int material = add_material(material_of("eyes", wet));
    primitives_.push_back(pelage::add_eyes(file_, eyes, scene_.model.surface.mesh().size, material));
  }

  /// Adds the shells of a coat; returns their triangles.
  std::uint64_t add_coat(const ShellCoat& coat, int shell_count) {
    const CornerMesh mesh = make_corner_mesh(coat.scene.view());
    if (mesh.triangles.empty()) return 0;  // glTF has no empty arrays
    const GltfJson shared = shared_attributes(coat, mesh);
    const int triangles = file_.add_triangles(mesh.triangles, mesh.corners.size());
    const std::vector<std::string> textures = shell_textures(coat.slices, shell_count);
    for (int shell = 0; shell < shell_count; ++shell) {
      const double height = bin_of(shell, shell_count).height;
      GltfJson attributes = shared;
      add_points(coat, mesh, height, attributes);
      const int material =
          add_shell_material(fmt::format("{} {}", coat.name, shell + 1), textures[static_cast<std::size_t>(shell)]);
      primitives_.push_back({{"attributes", attributes}, {"indices", triangles}, {"material", material}});
    }
    return static_cast<std::uint64_t>(shell_count) * mesh.triangles.size();
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
  int add_material(GltfJson material) {
    materials_.push_back(std::move(material));
    return static_cast<int>(materials_.size()) - 1;
  }

  int add_shell_material(const std::string& name, const std::string& texture) {
    const int image = file_.add_png(texture);
    textures_.push_back({{"source", image}, {"sampler", 0}});
    GltfJson material = material_of(name, 0.9);
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", textures_.size() - 1}};
    return add_material(std::move(material));
  }

  GltfJson shared_attributes(const ShellCoat& coat, const CornerMesh& mesh) {
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    for (const CornerMesh::Corner& corner : mesh.corners) {
      normals.push_back(scene_.model.surface.mesh().normals[corner.vertex]);
      uvs.push_back(corner.tile_uv / static_cast<float>(coat.scene.coat().tile));
    }
    return {{"NORMAL", file_.add(std::span(std::as_const(normals)))},
            {"TEXCOORD_0", file_.add(std::span(std::as_const(uvs)))}};
  }

  /// Adds the positions and colours of a shell at a height of the fur.
  void add_points(const ShellCoat& coat, const CornerMesh& mesh, double height, GltfJson& attributes) {
    const SceneView view = coat.scene.view();
    const std::vector<glm::vec3> vertex_positions = positions_at(view, height);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> colours;
    for (const CornerMesh::Corner& corner : mesh.corners) {
      positions.push_back(vertex_positions[corner.vertex]);
      const glm::vec3 lit =
          ShellTexture::headroom * light_at(coat.slices, height) * coat.colours.at(corner.vertex, height);
      const float density = view.fields.number(Field::density, corner.vertex);
      colours.emplace_back(glm::min(lit, 1.0f), corner.weight * density);
    }
    attributes["POSITION"] = file_.add_positions(positions);
    attributes["COLOR_0"] = file_.add(std::span(std::as_const(colours)));
  }

  const SceneView& scene_;
  const FileTransform& transform_;
  GlbWriter file_;
  GltfJson primitives_ = GltfJson::array(), materials_ = GltfJson::array(), textures_ = GltfJson::array();
};

}  // namespace

Result<BakedShells> bake_shells(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request) {
  const std::vector<VertexColours> colours = colours_of_coats(scene.model.surface, strands);
  ShellFile file(scene, strands.transform);
  BakedShells baked;
  baked.triangles = scene.model.surface.mesh().triangles.size();
  for (std::size_t c = 0; c < strands.coats(); ++c) {
    const CoatAlone alone(scene, static_cast<CoatId>(strands.groups[c].id));
    const Slices slices = bake_slices(alone.coat());
    if (c == 0) file.add_skin(VertexColours(colours), slices);
    baked.triangles += file.add_coat({strands.groups[c].name, alone, colours[c], slices}, request.shells);
  }
  file.add_eyes(make_frame(scene, FrameRequest{}).eyes);
  Result<std::string> glb = file.finish();
  if (!glb) return glb.status();
  baked.glb = std::move(*glb);
  return baked;
}

}  // namespace pelage
