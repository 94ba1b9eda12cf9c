#include "renderer/marched/hair_ribbons.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "protocol/base/clamped_index.h"
#include "protocol/base/lean_curve.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

float smoothed(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// What all places of a hair share.
struct Hair {
  const HairRoot& root;
  glm::vec3 place{0}, normal{0, 1, 0};  // of the skin
  float fur_length = 0, stretch = 1;
  glm::vec3 bends_to{0};  // how far its tip is bowed
  float lightness = 1, width = 1;
  glm::vec2 tile{0};  // in tiles
};

template <class Of>
auto at_root(const HairRoot& root, const Of& of) {
  return root.weights.x * of(root.corners.x) + root.weights.y * of(root.corners.y) +
         root.weights.z * of(root.corners.z);
}

float length_at(const MarchMesh& mesh, std::uint32_t vertex) {
  return mesh.groom[vertex].z * (mesh.variation.empty() ? 1 : mesh.variation[vertex].x);
}

Hair hair_of(const Coat& coat, const HairRoot& root, const MarchScene& scene) {
  const MarchMesh& mesh = scene.mesh;
  Hair hair{root};
  hair.place = at_root(root, [&](std::uint32_t v) { return mesh.positions[v]; });
  hair.normal = unit_of(at_root(root, [&](std::uint32_t v) { return mesh.normals[v]; }));
  hair.fur_length = at_root(root, [&](std::uint32_t v) { return length_at(mesh, v); });
  hair.tile = at_root(root, [&](std::uint32_t v) { return mesh.tiles[v]; }) * scene.optics.frame.tile.x;
  if (!mesh.paint.empty()) hair.width = at_root(root, [&](std::uint32_t v) { return mesh.paint[v][1]; });
  const float longer = root.number(0);
  hair.stretch = glm::mix(0.8f, 1.25f, longer * longer);  // few reach far out of the fur
  const glm::vec3 hint = std::abs(hair.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 sideways = unit_of(glm::cross(hair.normal, hint));
  const float angle = 6.2831853f * root.number(10);
  const auto bow = static_cast<float>((coat.bend + coat.mess) * nominal_length);
  hair.bends_to = (sideways * std::cos(angle) + glm::cross(hair.normal, sideways) * std::sin(angle)) *
                  (bow * std::min(hair.fur_length / static_cast<float>(nominal_length), 1.0f));
  hair.lightness = std::exp2(2 * static_cast<float>(coat.colour_spread) * (2 * root.number(20) - 1));
  return hair;
}

/// Opacity over that of a hair that is seen from the side in whole fur; 0 for one that does not stand.
float strength_of(const Hair& hair, const MarchScene& scene) {
  const MarchMesh& mesh = scene.mesh;
  const float facing = std::abs(glm::dot(unit_of(scene.viewpoint - hair.place), hair.normal));
  if (!mesh.paint.empty()) {
    const float density = at_root(hair.root, [&](std::uint32_t v) { return mesh.paint[v][0]; });
    const HairRoot other{.bits = hair.root.bits * 2654435769u};
    if (density < 1 && other.number(10) >= density) return 0;
  }
  return smoothed(0, 0.008f, hair.fur_length) * (1 - smoothed(0.4f * hair_limit, hair_limit, facing));
}

/// A place of the coat's coarse colours, linear: of a few strands about it.
glm::vec3 strand_colour(const MarchScene& scene, glm::vec2 tile, float height) {
  constexpr int level = 5, side = slice_texels >> level;
  const auto texel = [](float at) { return static_cast<int>((at - std::floor(at)) * side) & (side - 1); };
  const int slice = clamped_index(height * slice_count, 0, slice_count - 1);
  const auto at = static_cast<std::size_t>(scene.atlas->first[level] +
                                           (texel(tile.y) * side + texel(tile.x)) * slice_count + slice);
  const auto word = static_cast<std::uint32_t>(scene.atlas->colours[at]);
  const glm::vec3 root = glm::vec3(word & 255u, word >> 8 & 255u, word >> 16 & 255u) / 255.0f;
  return root * root;
}

RibbonEnd end_of(const Coat& coat, const Hair& hair, const MarchScene& scene, const RibbonCamera& camera, float s) {
  const MarchMesh& mesh = scene.mesh;
  glm::vec3 tangent(0);
  glm::vec3 place = at_root(hair.root, [&](std::uint32_t v) {
    const Lean<float> lean = lean_of(glm::vec2(mesh.groom[v]), mesh.normals[v], mesh.tangents[v]);
    const float varied = mesh.variation.empty() ? 0 : mesh.variation[v].y;
    const double inclination = std::clamp(double{lean.inclination} + double{varied}, 0.0, 1.0);
    const LeanPoint point = lean_point(coat.lean_curve, inclination, coat.root_share, double{s});
    const glm::vec3 way =
        static_cast<float>(point.across) * lean.along + static_cast<float>(point.up) * mesh.normals[v];
    return mesh.positions[v] + length_at(mesh, v) * hair.stretch * way;
  });
  tangent = at_root(hair.root, [&](std::uint32_t v) {
    const Lean<float> lean = lean_of(glm::vec2(mesh.groom[v]), mesh.normals[v], mesh.tangents[v]);
    const float varied = mesh.variation.empty() ? 0 : mesh.variation[v].y;
    const double inclination = std::clamp(double{lean.inclination} + double{varied}, 0.0, 1.0);
    const LeanPoint point = lean_point(coat.lean_curve, inclination, coat.root_share, double{s});
    return static_cast<float>(std::sin(point.angle)) * lean.along +
           static_cast<float>(std::cos(point.angle)) * mesh.normals[v];
  });
  place += hair.bends_to * (s * s);
  tangent += hair.bends_to * (2 * s / std::max(hair.fur_length * hair.stretch, 1e-6f));
  const auto width = static_cast<float>(glm::mix(coat.width_root, coat.width_tip, double{s})) * hair.width;
  RibbonEnd end = ribbon_end(place, unit_of(tangent), width, camera);
  end.height = std::min(s * hair.stretch, 1.0f);
  end.colour = strand_colour(scene, hair.tile, end.height) * hair.lightness;
  return end;
}

}  // namespace

std::vector<Ribbon> hair_ribbons(const Coat& coat, std::span<const HairRoot> roots, const MarchScene& scene,
                                 const RibbonCamera& camera) {
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Hair hair = hair_of(coat, roots[i], scene);
    const float strength = strength_of(hair, scene);
    if (!(strength > 0)) continue;
    RibbonEnd from = end_of(coat, hair, scene, camera, 0);
    for (int k = 1; k <= hair_segments; ++k) {
      const RibbonEnd to = end_of(coat, hair, scene, camera, static_cast<float>(k) / hair_segments);
      if (from.inverse > 0 && to.inverse > 0) {
        Ribbon& ribbon = ribbons.emplace_back(Ribbon{from, to, hair.normal, 0.5f, static_cast<int>(i)});
        ribbon.root.strength *= strength, ribbon.tip.strength *= strength;
      }
      from = to;
    }
  }
  return ribbons;
}

}  // namespace pelage
