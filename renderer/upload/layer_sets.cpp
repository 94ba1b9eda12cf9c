#include "renderer/upload/layer_sets.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr float full_tangent = 5.0f;  // of the angle from which all shells are drawn: 79 degrees
constexpr float furthest_averted =
    -0.6f;  // fur on triangles turned further away lies behind the skin that faces the eye

}  // namespace

int shells_of_set(int shells, int set) {
  const int part = 1 << (layer_sets - 1 - set);
  return (shells + part - 1) / part;
}

int steps_of_set(int steps, int set) { return std::min(16, (steps * (layer_sets + 1 - set) + 1) / 2); }

float layer_level(const LayerView& view, glm::vec3 position, glm::vec3 normal, float length) {
  constexpr float highest = layer_sets - 1;
  if (view.policy == ShellPolicy::uniform) return highest;
  const glm::vec3 to_eye = view.eye - position;
  const float distance = std::max(glm::length(to_eye), 1e-6f);
  const float cosine = std::min(1.0f, std::abs(glm::dot(to_eye, normal)) / distance);
  const float tangent = std::sqrt(1 - cosine * cosine) / std::max(cosine, 1e-3f);
  const float by_angle = std::min(1.0f, tangent / full_tangent);
  const float by_size = length / (view.pixel * distance * static_cast<float>(view.shells));
  return std::clamp(highest + std::log2(std::max(std::min(by_angle, by_size), 1e-6f)), 0.0f, highest);
}

float set_share(float level, int set) {
  const float near =
      1.0f - std::abs(level - static_cast<float>(set));  // a tent, cut off so that few triangles need both
  return std::clamp(2.0f * near - 0.5f, 0.0f, 1.0f);
}

LayerLists sort_triangles(const LayerMesh& mesh, glm::vec3 eye) {
  LayerLists lists;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::vec3 to_eye = eye - mesh.centroids[i], normal = mesh.normals[i];
    const float cosine = glm::dot(to_eye, normal) / std::max(glm::length(to_eye) * glm::length(normal), 1e-20f);
    if (cosine <= furthest_averted) continue;
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

}  // namespace pelage
