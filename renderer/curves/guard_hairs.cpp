#include "renderer/curves/guard_hairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "protocol/base/random.h"

namespace pelage {

namespace {

constexpr std::uint64_t hair_seed = 0x6861697273;

float area_of(const HairMesh& mesh, glm::uvec3 t) {
  const glm::vec3 a = mesh.positions[t.x];
  return 0.5f * glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
}

std::array<std::uint32_t, 3> welded_corners(const HairMesh& mesh, glm::uvec3 t) {
  return {mesh.welded[t.x], mesh.welded[t.y], mesh.welded[t.z]};
}

/// Cosine of the angle between the fur and the way to the eye, and the distance.
struct Facing {
  float cosine, distance;
};
Facing facing_of(const HairMesh& mesh, const HairRoot& root, glm::vec3 viewpoint) {
  glm::vec3 place(0), normal(0);
  for (int k = 0; k < 3; ++k) {
    place += root.weights[k] * mesh.positions[root.corners[k]];
    normal += root.weights[k] * mesh.normals[root.corners[k]];
  }
  const glm::vec3 to_camera = viewpoint - place;
  const float distance = glm::length(to_camera);
  return {glm::dot(to_camera, normal) / std::max(distance * glm::length(normal), 1e-20f), distance};
}

/// The first piece of each triangle of the surface.
std::vector<glm::uvec3> surface_triangles(const HairMesh& mesh) {
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return welded_corners(mesh, mesh.triangles[i]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  order.erase(std::unique(order.begin(), order.end(), [&](auto a, auto b) { return key(a) == key(b); }), order.end());
  std::vector<glm::uvec3> triangles;
  for (const std::size_t i : order) triangles.push_back(mesh.triangles[i]);
  return triangles;
}

}  // namespace

std::vector<HairRoot> scatter_hairs(const HairMesh& mesh, int count) {
  const std::vector<glm::uvec3> triangles = surface_triangles(mesh);
  std::vector<double> sums;
  double area = 0;
  for (const glm::uvec3& t : triangles) sums.push_back(area += area_of(mesh, t));
  std::vector<HairRoot> roots;
  if (!(area > 0)) return roots;
  Random random(hair_seed);
  for (int i = 0; i < count; ++i) {
    const double at = (i + random.uniform()) / count * area;  // one in each equal part of the area
    const auto found = std::min<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin()), sums.size() - 1);
    const double root = std::sqrt(random.uniform()), share = random.uniform();  // uniform on a triangle
    const glm::vec3 weights(1 - root, root * (1 - share), root * share);
    roots.push_back({triangles[found], static_cast<std::uint32_t>(random.uniform() * 4294967296.0), weights});
  }
  return roots;
}

ShownHairs shown_hairs(const HairMesh& mesh, std::span<const HairRoot> roots, glm::vec3 viewpoint) {
  std::vector<std::pair<Facing, HairRoot>> chosen;
  for (const HairRoot& root : roots) {
    const Facing facing = facing_of(mesh, root, viewpoint);
    if (std::abs(facing.cosine) < hair_limit) chosen.emplace_back(facing, root);
  }
  const auto behind = [](const auto& a, const auto& b) {
    const bool a_back_facing = a.first.cosine < 0, b_back_facing = b.first.cosine < 0;
    return a_back_facing != b_back_facing ? a_back_facing : a.first.distance > b.first.distance;
  };
  std::stable_sort(chosen.begin(), chosen.end(), behind);
  ShownHairs shown;
  for (const auto& [facing, root] : chosen) {
    shown.back_facing += facing.cosine < 0;
    shown.roots.push_back(root);
  }
  return shown;
}

}  // namespace pelage
