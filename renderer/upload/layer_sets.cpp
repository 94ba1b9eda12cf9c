#include "renderer/upload/layer_sets.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr float full_tangent = 5.0f;  // of the angle from which all shells are drawn: 79 degrees
constexpr float full_bending = 1.5f;  // of the normal over the length of the fur, radians

float cosine_to_eye(const LayerMesh& mesh, std::size_t triangle, glm::vec3 eye) {
  const glm::vec3 to_eye = eye - mesh.centroids[triangle], normal = mesh.normals[triangle];
  return glm::dot(to_eye, normal) / std::max(glm::length(to_eye) * glm::length(normal), 1e-20f);
}

}  // namespace

int shells_of_set(int shells, int set) {
  const int part = 1 << (layer_sets - 1 - set);
  return (shells + part - 1) / part;
}

int steps_of_set(int steps, int set) { return std::min(16, (steps * (layer_sets + 1 - set) + 1) / 2); }

float layer_level(const LayerView& view, const LayerVertex& vertex) {
  constexpr float highest = layer_sets - 1;
  if (view.policy == ShellPolicy::uniform) return highest;
  const glm::vec3 to_eye = view.eye - vertex.position;
  const float distance = std::max(glm::length(to_eye), 1e-6f);
  const float cosine = std::min(1.0f, std::abs(glm::dot(to_eye, vertex.normal)) / distance);
  const float tangent = std::sqrt(1 - cosine * cosine) / std::max(cosine, 1e-3f);
  const float by_angle = tangent / full_tangent;
  const float by_bending = vertex.length * vertex.curvature / full_bending;
  const float by_size = vertex.length / (view.pixel * distance * static_cast<float>(view.shells));
  const float share = std::min({std::max(by_angle, by_bending), by_size, 1.0f});
  return std::clamp(highest + std::log2(std::max(share, 1e-6f)), 0.0f, highest);
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

float set_share(float level, int set) {
  const float near =
      1.0f - std::abs(level - static_cast<float>(set));  // a tent, cut off so that few triangles need both
  return std::clamp(6.0f * near - 2.5f, 0.0f, 1.0f);
}

LayerLists sort_triangles(const LayerMesh& mesh, glm::vec3 eye, float furthest) {
  LayerLists lists;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const float cosine = cosine_to_eye(mesh, i, eye);
    if (cosine <= furthest) continue;
    const glm::uvec3 t = mesh.triangles[i];
    for (int set = 0; set < layer_sets; ++set) {
      const auto shown = [&](std::uint32_t v) { return set_share(mesh.levels[v], set) > 0; };
      if (!shown(t.x) && !shown(t.y) && !shown(t.z)) continue;
      LayerTriangles& list = lists[static_cast<std::size_t>(set)];
      (cosine >= 0 ? list.facing : list.averted).push_back(t);
    }
  }
  return lists;
}

std::vector<glm::uvec3> shown_triangles(const LayerMesh& mesh, glm::vec3 eye) {
  std::vector<glm::uvec3> shown;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (cosine_to_eye(mesh, i, eye) > furthest_averted) shown.push_back(mesh.triangles[i]);
  }
  return shown;
}

}  // namespace pelage
