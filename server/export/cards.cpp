#include "server/export/cards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/coat/slices.h"
#include "server/export/card_texture.h"
#include "server/export/clumps.h"
#include "server/export/eye_part.h"
#include "server/export/skin_part.h"
#include "server/fields/coats.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

constexpr double overlap = 1.9;   // width of a card, relative to the distance to the next
constexpr double max_turn = 0.4;  // of a card around its middle line, radians

/// Number of rows of quads for each level.
constexpr std::array<std::size_t, card_levels> rows_of_level{CardLine::rows - 1, 3, 2};

struct CardMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec4> colours;
  std::vector<glm::uvec3> triangles;
};

/// Returns the unit vector that a card faces: the skin's normal or, for a strand along the normal, a random tangent.
glm::vec3 level_of(const CardLine& clump, glm::vec3 along) {
  const glm::vec3 across = glm::cross(along, clump.normal);
  if (glm::length(across) > 0.25f * glm::length(along)) return clump.normal;
  const glm::vec3 any = std::abs(clump.normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 u = glm::normalize(glm::cross(clump.normal, any)), v = glm::cross(clump.normal, u);
  const float turn = 6.2831853f * clump.number;
  return std::cos(turn) * u + std::sin(turn) * v;
}

/// Returns the unit vector from the middle line of the card to its right side, with the card's random turn.
glm::vec3 side_of(const CardLine& clump, glm::vec3 level, glm::vec3 along) {
  const auto turn = static_cast<float>(max_turn * (2 * std::fmod(7.0 * double{clump.number}, 1.0) - 1));
  const glm::vec3 across = glm::cross(along, level);
  const float length = glm::length(across);
  if (!(length > 1e-12f)) return glm::normalize(glm::cross(level, clump.normal) + 1e-6f * clump.normal);
  const glm::vec3 side = across / length;
  return std::cos(turn) * side + std::sin(turn) * glm::cross(glm::normalize(along), side);
}

/// Adds a card that is `width` sizes wide.
void add_card(const CardLine& clump, double width, std::size_t rows, const Slices& slices, double size,
              CardMesh& mesh) {
  const glm::vec3 level = level_of(clump, clump.positions.back() - clump.positions.front());
  const auto lock = static_cast<float>(std::min(static_cast<int>(clump.number * card_locks), card_locks - 1));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t row = 0; row <= rows; ++row) {
    const double height = static_cast<double>(row) / static_cast<double>(rows);
    const auto at = static_cast<std::size_t>(std::lround(height * (CardLine::rows - 1)));
    const glm::vec3 along =
        clump.positions[std::min(at + 1, CardLine::rows - 1)] - clump.positions[at > 0 ? at - 1 : 0];
    const glm::vec3 half = side_of(clump, level, along) * static_cast<float>(0.5 * width);
    const float light = glm::mix(light_at(slices, height), 1.0f, 0.5f);  // halved: cards hide the roots of others, too
    const glm::vec4 colour(glm::min(light * clump.colours[at] / card_lightness, 1.0f), 1);
    for (const float right : {0.0f, 1.0f}) {
      mesh.positions.push_back((clump.positions[at] + (2 * right - 1) * half) * static_cast<float>(size));
      mesh.normals.push_back(clump.normal);
      mesh.uvs.emplace_back((lock + right) / card_locks, 1 - static_cast<float>(height));
      mesh.colours.push_back(colour);
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t a = first + 2 * row;
    mesh.triangles.emplace_back(a, a + 1, a + 2), mesh.triangles.emplace_back(a + 1, a + 3, a + 2);
  }
}

/// A coat of which the file has cards.
struct CardCoat {
  const std::string& name;
  const Coat& coat;
  Slices light;       // without texels
  int material = -1;  // -1 until the coat has a card
};

/// The file with its materials and textures.
class CardWriter {
 public:
  explicit CardWriter(double card_width) : card_width_(card_width) {}

  int add_material(GltfJson material) {
    materials_.push_back(std::move(material));
    return static_cast<int>(materials_.size()) - 1;
  }

  /// Adds the cards of a coat. The coat's material is made for its first cards.
  GltfJson add_cards(const CardMesh& mesh, CardCoat& coat) {
    if (coat.material < 0) coat.material = add_card_material(coat);
    return {{"attributes",
             {{"POSITION", file.add_positions(mesh.positions)},
              {"NORMAL", file.add(std::span<const glm::vec3>(mesh.normals))},
              {"TEXCOORD_0", file.add(std::span<const glm::vec2>(mesh.uvs))},
              {"COLOR_0", file.add(std::span<const glm::vec4>(mesh.colours))}}},
            {"indices", file.add_triangles(mesh.triangles, mesh.positions.size())},
            {"material", coat.material}};
  }

  Result<std::string> finish() {
    if (!textures_.empty()) file.set("textures", std::move(textures_)), file.set_sampler(clamped);
    file.set("materials", std::move(materials_));
    return file.finish();
  }

  GlbWriter file;

 private:
  int add_card_material(const CardCoat& coat) {
    GltfJson material = material_of(coat.name, 0.8);
    material.update({{"alphaMode", "MASK"}, {"alphaCutoff", 0.4}, {"doubleSided", true}});
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", textures_.size()}};
    const int picture = file.add_png(encode_png(card_texture(coat.coat, card_width_), true));
    textures_.push_back({{"source", picture}, {"sampler", 0}});
    return add_material(std::move(material));
  }

  double card_width_;  // sizes
  GltfJson materials_ = GltfJson::array(), textures_ = GltfJson::array();
};

/// Mesh 0 is the body; the next meshes are the cards of the levels that have any. Each scene has nodes of its own,
/// because readers move a node that two scenes share from one to the other.
void set_scenes(GlbWriter& file, GltfJson body, const std::vector<GltfJson>& levels, const FileTransform& transform) {
  GltfJson scenes = GltfJson::array(), nodes = GltfJson::array(), meshes = GltfJson::array();
  const auto add_mesh = [&](const std::string& name, GltfJson primitives) {
    meshes.push_back({{"name", name}, {"primitives", std::move(primitives)}});
    return meshes.size() - 1;
  };
  const auto add_node = [&](const std::string& name, std::size_t mesh) {
    nodes.push_back(node_of(name, mesh, transform));
    return nodes.size() - 1;
  };
  add_mesh("body", std::move(body));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    GltfJson shown = GltfJson::array({add_node(fmt::format("body_LOD{}", k), 0)});
    const std::string fur = fmt::format("fur_LOD{}", k);
    if (!levels[k].empty()) shown.push_back(add_node(fur, add_mesh(fur, levels[k])));
    scenes.push_back({{"name", fmt::format("LOD{}", k)}, {"nodes", std::move(shown)}});
  }
  file.set("scene", 0);
  file.set("scenes", std::move(scenes));
  file.set("nodes", std::move(nodes));
  file.set("meshes", std::move(meshes));
}

}  // namespace

namespace {

std::vector<CardCoat> coats_of(const FurFrame& frame) {
  std::vector<CardCoat> coats;
  for (const NamedCoat& coat : frame.coats)
    coats.push_back({coat.name, coat.coat, without_texels(bake_slices(coat.coat))});
  return coats;
}

/// Adds a level of detail, a primitive for each coat that has cards in it.
GltfJson add_level(CardWriter& writer, const std::vector<CardLine>& clumps, double width, std::size_t rows, double size,
                   std::vector<CardCoat>& coats) {
  std::vector<CardMesh> meshes(coats.size());
  for (const CardLine& clump : clumps) add_card(clump, width, rows, coats[clump.coat].light, size, meshes[clump.coat]);
  GltfJson primitives = GltfJson::array();
  for (std::size_t c = 0; c < coats.size(); ++c)
    if (!meshes[c].triangles.empty()) primitives.push_back(writer.add_cards(meshes[c], coats[c]));
  return primitives;
}

}  // namespace

Result<CardFile> bake_cards(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request) {
  const FurFrame frame = make_frame(scene, FrameRequest{});
  std::vector<CardCoat> coats = coats_of(frame);
  const double cell = cell_of(strands, request.cards);
  CardWriter writer(overlap * cell);
  const VertexColours colours(colours_of_coats(scene.model.surface, strands));
  GltfJson body = GltfJson::array();
  body.push_back(
      add_skin(writer.file, scene, colours, coats.front().light, writer.add_material(material_of("skin", dull))));
  if (!frame.eyes.empty())
    body.push_back(add_eyes(writer.file, frame.eyes, strands.size, writer.add_material(material_of("eyes", wet))));
  CardFile result;
  result.triangles = scene.model.surface.mesh().triangles.size();
  std::vector<GltfJson> levels;
  for (int level = 0; level < card_levels; ++level) {
    const double distance = cell * std::pow(2.0, 0.5 * level);
    const std::size_t rows = rows_of_level[static_cast<std::size_t>(level)];
    const std::vector<CardLine> clumps = make_clumps(strands, distance);
    if (level == 0) result.cards = clumps.size(), result.triangles += 2 * rows * clumps.size();
    levels.push_back(add_level(writer, clumps, overlap * distance, rows, strands.size, coats));
  }
  set_scenes(writer.file, std::move(body), levels, strands.transform);
  Result<std::string> glb = writer.finish();
  if (!glb) return glb.status();
  result.glb = std::move(*glb);
  return result;
}

}  // namespace pelage
