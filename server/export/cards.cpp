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

GltfJson add_cards(GlbWriter& file, const CardMesh& mesh, int material) {
  return {{"attributes",
           {{"POSITION", file.add_positions(mesh.positions)},
            {"NORMAL", file.add(std::span<const glm::vec3>(mesh.normals))},
            {"TEXCOORD_0", file.add(std::span<const glm::vec2>(mesh.uvs))},
            {"COLOR_0", file.add(std::span<const glm::vec4>(mesh.colours))}}},
          {"indices", file.add_triangles(mesh.triangles, mesh.positions.size())},
          {"material", material}};
}

/// The materials that a file uses besides the skin's. Unused materials are left out, so that later numbers change.
struct CardMaterials {
  bool eyes = false, cards = false;

  static constexpr int skin_number = 0, eye_number = 1;
  int card_number() const { return eyes ? 2 : 1; }
};

void set_materials(GlbWriter& file, const CardMaterials& used, const Coat& coat, double width) {
  GltfJson materials = GltfJson::array({material_of("skin", dull)});
  if (used.eyes) materials.push_back(material_of("eyes", wet));
  if (used.cards) {
    GltfJson& cards = materials.emplace_back(material_of("cards", 0.8));
    cards.update({{"alphaMode", "MASK"}, {"alphaCutoff", 0.4}, {"doubleSided", true}});
    cards["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const int picture = file.add_png(encode_png(card_texture(coat, width), true));
    file.set("textures", GltfJson::array({{{"source", picture}, {"sampler", 0}}}));
    file.set_sampler(clamped);
  }
  file.set("materials", std::move(materials));
}

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
    if (!levels[k].is_null()) shown.push_back(add_node(fur, add_mesh(fur, GltfJson::array({levels[k]}))));
    scenes.push_back({{"name", fmt::format("LOD{}", k)}, {"nodes", std::move(shown)}});
  }
  file.set("scene", 0);
  file.set("scenes", std::move(scenes));
  file.set("nodes", std::move(nodes));
  file.set("meshes", std::move(meshes));
}

}  // namespace

Result<CardFile> bake_cards(const SceneView& scene, const ExportedStrands& strands, const ExportRequest& request) {
  const Slices slices = bake_slices(first_unmuted(scene.settings.coats).coat);
  const FurFrame frame = make_frame(scene, FrameRequest{});
  const double cell = cell_of(strands, request.cards);
  CardFile result;
  GlbWriter file;
  CardMaterials used{.eyes = !frame.eyes.empty()};
  GltfJson body = GltfJson::array();
  body.push_back(
      add_skin(file, scene, VertexColours(scene.model.surface, strands), slices, CardMaterials::skin_number));
  if (used.eyes) body.push_back(add_eyes(file, frame.eyes, strands.size, CardMaterials::eye_number));
  std::vector<GltfJson> levels;
  for (int level = 0; level < card_levels; ++level) {
    const double distance = cell * std::pow(2.0, 0.5 * level);
    CardMesh mesh;
    const std::vector<CardLine> clumps = make_clumps(strands, distance);
    for (const CardLine& clump : clumps)
      add_card(clump, overlap * distance, rows_of_level[static_cast<std::size_t>(level)], slices, strands.size, mesh);
    if (level == 0) result.cards = clumps.size(), result.triangles = mesh.triangles.size();
    levels.push_back(clumps.empty() ? GltfJson() : add_cards(file, mesh, used.card_number()));
    used.cards |= !clumps.empty();
  }
  result.triangles += scene.model.surface.mesh().triangles.size();
  set_materials(file, used, first_unmuted(scene.settings.coats).coat, overlap * cell);
  set_scenes(file, std::move(body), levels, strands.transform);
  Result<std::string> glb = file.finish();
  if (!glb) return glb.status();
  result.glb = std::move(*glb);
  return result;
}

}  // namespace pelage
