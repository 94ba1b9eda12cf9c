#include "renderer/upload/shell_lod.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr float full_tangent = 5.6f;  // tangent of the view angle from which all shells are drawn: 80 degrees
constexpr float full_bending = 1.5f;  // bending over the fur's length from which all shells are drawn, radians
constexpr float max_bending = 1e3f;   // larger values are clamped
constexpr float shells_per_pixel = 1.0f;
constexpr float past_skin = 2.0f;  // factor on the tangent below; 1 would cost a fifth more fragments for .001 of FLIP

float cosine_to_camera(const ShellMesh& mesh, std::size_t triangle, glm::vec3 viewpoint) {
  const glm::vec3 to_camera = viewpoint - mesh.centroids[triangle], normal = mesh.normals[triangle];
  return glm::dot(to_camera, normal) / std::max(glm::length(to_camera) * glm::length(normal), 1e-20f);
}

/// Returns the tangent of the angle at the hull from which a ray misses the skin, so that the edges of shells would be
/// visible against the background. The skin bends by `bending` radians over the length of its fur, as a sphere does.
float tangent_past_skin(float bending) { return past_skin / std::sqrt(std::max(bending * (2 + bending), 1e-6f)); }

}  // namespace

int max_lod(int shells, ShellPolicy policy) {
  int lod = 0;
  while (policy == ShellPolicy::adaptive && lod < max_shell_lod && shells >> (lod + 1) >= min_shells) ++lod;
  return lod;
}

int gone_from(int shell) {
  int lod = 1;
  while (lod <= max_shell_lod && shell % (1 << lod) == 0) ++lod;
  return lod;
}

float slab_begin(int shell, int shells, float lod) {
  float height = static_cast<float>(shell);
  for (int halving = 0; halving < max_shell_lod; ++halving) {
    const int step = 1 << halving;
    if ((shell & step) == 0) continue;
    height += static_cast<float>(step) * std::clamp(lod - static_cast<float>(halving), 0.0f, 1.0f);
    shell += step;
  }
  return std::min(height, static_cast<float>(shells));
}

float shell_lod(const ShellView& view, const ShellVertex& vertex) {
  const float highest = static_cast<float>(max_lod(view.shells, view.policy));
  if (highest == 0) return 0;
  const glm::vec3 to_camera = view.viewpoint - vertex.position;
  const float distance = std::max(glm::length(to_camera), 1e-6f);
  const float cosine = std::min(1.0f, std::abs(glm::dot(to_camera, vertex.normal)) / distance);
  const float tangent = std::sqrt(1 - cosine * cosine) / std::max(cosine, 1e-3f);
  const float bending = std::min(max_bending, vertex.length * vertex.curvature);
  const float by_angle = tangent / std::min(full_tangent, tangent_past_skin(bending));
  const float by_bending = bending / full_bending;
  const float by_size = shells_per_pixel * vertex.length / (view.pixel * distance * static_cast<float>(view.shells));
  const float share = std::min({std::max(by_angle, by_bending), by_size, 1.0f});
  return std::clamp(-std::log2(std::max(share, 1e-6f)), 0.0f, highest);
}

std::vector<float> curvatures(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const glm::uvec3> triangles) {
  std::vector<float> sum(positions.size()), edges(positions.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    const float bend =
        glm::distance(normals[a], normals[b]) / std::max(glm::distance(positions[a], positions[b]), 1e-6f);
    sum[a] += bend, sum[b] += bend;
    edges[a] += 1, edges[b] += 1;
  };
  for (const glm::uvec3& t : triangles) add(t.x, t.y), add(t.y, t.z), add(t.z, t.x);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(edges[i], 1.0f);
  return sum;
}

ShellLists sort_triangles(const ShellMesh& mesh, const ShellView& view) {
  const int highest = max_lod(view.shells, view.policy);
  ShellLists lists;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const float cosine = cosine_to_camera(mesh, i, view.viewpoint);
    if (cosine <= view.furthest) continue;
    const glm::uvec3 t = mesh.triangles[i];
    ShellLists::OfLods& side = cosine >= 0 ? lists.facing : lists.back_facing;
    const float lowest = highest == 0 ? 0 : std::min({mesh.lods[t.x], mesh.lods[t.y], mesh.lods[t.z]});
    for (int lod = std::min(highest, static_cast<int>(lowest)); lod <= highest; ++lod)
      side[static_cast<std::size_t>(lod)].push_back(t);
  }
  return lists;
}

}  // namespace pelage
