#include "server/export/shells.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
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

/// Returns the texture of each shell as PNG. Works in parallel, since the compression takes longer than all the rest.
std::vector<std::string> shell_textures(const Slices& slices, int shell_count) {
  std::vector<std::string> textures(static_cast<std::size_t>(shell_count));
  for_each_in_parallel(static_cast<std::uint32_t>(shell_count), [&](std::uint32_t shell) {
    const SliceBin bin = bin_of(static_cast<int>(shell), shell_count);
    textures[shell] = encode_png(ShellTexture(slices.levels.front(), bin).image(), true);
  });
  return textures;
}

/// A coat and what all of its shells share.
struct ShellCoat {
  std::string name;
  CoatAlone scene;
  const VertexColours* colours;
  CornerMesh mesh;
  double length = 0;  // mean where it grows, sizes
  Slices light;       // without texels
  std::vector<std::string> textures;

  ShellCoat(const SceneView& whole, const StrandGroup& group, const VertexColours& of_strands, int shell_count)
      : name(group.name),
        scene(whole, static_cast<CoatId>(group.id)),
        colours(&of_strands),
        mesh(make_corner_mesh(scene.view())) {
    const Slices slices = bake_slices(scene.coat());
    light = without_texels(slices);
    if (mesh.triangles.empty()) return;
    textures = shell_textures(slices, shell_count);
    double sum = 0, furred = 0;
    for (const CornerMesh::Corner& corner : mesh.corners) {
      const double here = double{scene.view().fields.number(Field::length, corner.vertex)};
      sum += here, furred += here > 0 ? 1 : 0;
    }
    length = sum / furred;
  }
};

struct Shell {
  std::size_t coat = 0;
  int number = 0;
};

/// Returns the shells of all coats from the skin outwards, by the mean heights at which they lie.
std::vector<Shell> shells_outwards(const std::vector<ShellCoat>& coats, int shell_count) {
  std::vector<Shell> shells;
  for (std::size_t c = 0; c < coats.size(); ++c) {
    for (int k = 0; k < shell_count && !coats[c].textures.empty(); ++k) shells.push_back({c, k});
  }
  const auto height = [&](const Shell& shell) {
    return coats[shell.coat].length * bin_of(shell.number, shell_count).height;
  };
  std::ranges::stable_sort(shells, {}, height);
  return shells;
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

  /// Adds one of `shell_count` shells of a coat.
  void add_shell(const ShellCoat& coat, int shell, int shell_count) {
    const std::string& texture = coat.textures[static_cast<std::size_t>(shell)];
    SharedParts& shared = shared_[&coat];
    if (shared.attributes.is_null()) shared = shared_parts(coat);
    GltfJson attributes = shared.attributes;
    add_points(coat, bin_of(shell, shell_count).height, attributes);
    const int material = add_shell_material(fmt::format("{} {}", coat.name, shell + 1), texture);
    primitives_.push_back({{"attributes", attributes}, {"indices", shared.triangles}, {"material", material}});
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

  /// What the shells of a coat share in the file.
  struct SharedParts {
    GltfJson attributes;
    int triangles = 0;
  };

  SharedParts shared_parts(const ShellCoat& coat) {
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    for (const CornerMesh::Corner& corner : coat.mesh.corners) {
      normals.push_back(scene_.model.surface.mesh().normals[corner.vertex]);
      uvs.push_back(corner.tile_uv / static_cast<float>(coat.scene.coat().tile));
    }
    GltfJson attributes = {{"NORMAL", file_.add(std::span(std::as_const(normals)))},
                           {"TEXCOORD_0", file_.add(std::span(std::as_const(uvs)))}};
    return {std::move(attributes), file_.add_triangles(coat.mesh.triangles, coat.mesh.corners.size())};
  }

  /// Adds the positions and colours of a shell at a height of the fur.
  void add_points(const ShellCoat& coat, double height, GltfJson& attributes) {
    const SceneView view = coat.scene.view();
    const std::vector<glm::vec3> vertex_positions = positions_at(view, height);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> colours;
    for (const CornerMesh::Corner& corner : coat.mesh.corners) {
      positions.push_back(vertex_positions[corner.vertex]);
      const glm::vec3 lit =
          ShellTexture::headroom * light_at(coat.light, height) * coat.colours->at(corner.vertex, height);
      const float density = view.fields.number(Field::density, corner.vertex);
      colours.emplace_back(glm::min(lit, 1.0f), corner.weight * density);
    }
    attributes["POSITION"] = file_.add_positions(positions);
    attributes["COLOR_0"] = file_.add(std::span(std::as_const(colours)));
  }

  const SceneView& scene_;
  const FileTransform& transform_;
  GlbWriter file_;
  std::map<const ShellCoat*, SharedParts> shared_;
  GltfJson primitives_ = GltfJson::array(), materials_ = GltfJson::array(), textures_ = GltfJson::array();
};

}  // namespace

Result<BakedShells> bake_shells(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request) {
  const std::vector<VertexColours> colours = colours_of_coats(scene.model.surface, strands);
  std::vector<ShellCoat> coats;
  for (std::size_t c = 0; c < colours.size(); ++c)
    coats.emplace_back(scene, strands.groups[c], colours[c], request.shells);
  ShellFile file(scene, strands.transform);
  BakedShells baked;
  baked.triangles = scene.model.surface.mesh().triangles.size();
  file.add_skin(VertexColours(colours), coats.front().light);
  for (const Shell& shell : shells_outwards(coats, request.shells)) {
    file.add_shell(coats[shell.coat], shell.number, request.shells);
    baked.triangles += coats[shell.coat].mesh.triangles.size();
  }
  file.add_eyes(make_frame(scene, FrameRequest{}).eyes);
  Result<std::string> glb = file.finish();
  if (!glb) return glb.status();
  baked.glb = std::move(*glb);
  return baked;
}

}  // namespace pelage
