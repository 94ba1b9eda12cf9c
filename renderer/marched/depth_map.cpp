#include "renderer/marched/depth_map.h"

#include <algorithm>

#include "renderer/marched/visible_triangles.h"

namespace pelage {

DepthMap draw_depth_map(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                        const LightView& light, int side, int threads) {
  const std::vector<VisibleTriangle> seen =
      visible_triangles(places, triangles, {light.world_to_clip, light.axis, side, side}, threads);
  DepthMap map{side, std::vector<float>(seen.size())};
  std::transform(seen.begin(), seen.end(), map.depths.begin(),
                 [](const VisibleTriangle& visible) { return visible.there() ? visible.depth : DepthMap::nowhere; });
  return map;
}

}  // namespace pelage
