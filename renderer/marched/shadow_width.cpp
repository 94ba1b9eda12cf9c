#include "renderer/marched/shadow_width.h"

#include <algorithm>

#include "renderer/marched/visible_triangles.h"
#include "renderer/shaders/constants.h"

namespace pelage {

std::vector<glm::vec2> occlusion_map(std::span<const glm::vec3> places, std::span<const glm::vec3> normals,
                                     std::span<const glm::uvec3> triangles, const LightView& light,
                                     const DepthMap& depths, int threads) {
  constexpr auto bias = static_cast<float>(cast_bias);
  std::vector<glm::vec2> occluded(depths.depths.size(), glm::vec2(0));
  const PlainRaster raster(places, triangles, {light.world_to_clip, light.axis, depths.side, depths.side});
  raster.visit(threads, [&](std::size_t texel, const VisibleTriangle& found) {
    const glm::uvec3& t = triangles[found.triangle];
    const glm::vec3 place = at_visible(found, places[t.x], places[t.y], places[t.z]);
    const glm::vec3 normal = at_visible(found, normals[t.x], normals[t.y], normals[t.z]);
    const float seen = depths.depths[texel];
    if (glm::dot(normal, light.viewpoint - place) > 0 && found.depth > seen + bias) occluded[texel] = {1, seen};
  });
  return occluded;
}

int shadow_width_side(int resolution) {
  int ratio = 4;
  while (resolution / ratio > 48) ratio *= 2;
  return std::max(1, resolution / ratio);
}

std::vector<glm::vec2> shadow_widths(std::span<const glm::vec2> occlusion, int side) {
  const int reduced = shadow_width_side(side), ratio = side / reduced, half = ratio / 2, across = ratio + 2 * half;
  std::vector<glm::vec2> widths(static_cast<std::size_t>(reduced) * static_cast<std::size_t>(reduced));
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, side - 1), y = std::clamp(y, 0, side - 1);
    return occlusion[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
  };
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const int left = static_cast<int>(i % static_cast<std::size_t>(reduced)) * ratio - half,
              top = static_cast<int>(i / static_cast<std::size_t>(reduced)) * ratio - half;
    glm::vec2 sum(0);
    for (int k = 0; k < across * across; ++k) sum += at(left + k % across, top + k / across);
    widths[i] = sum / static_cast<float>(across * across);
  }
  return widths;
}

}  // namespace pelage
