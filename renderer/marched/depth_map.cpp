#include "renderer/marched/depth_map.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

/// A corner on the map.
struct Corner {
  glm::dvec2 at{0};         // texels from the left and the top
  double over_w = 0;        // 1 over the distance to the light; 1 for a light far away
  double depth_over_w = 0;  // runs evenly over the map
};

Corner corner_of(glm::vec3 place, const LightView& light, int side) {
  const glm::dvec4 clip = glm::dmat4(light.world_to_clip) * glm::dvec4(place, 1);
  if (!(clip.w > 1e-6)) return {};
  const double over_w = 1 / clip.w;
  const glm::dvec2 at = (glm::dvec2(clip.x, -clip.y) * over_w * 0.5 + 0.5) * static_cast<double>(side);
  return {at, over_w, (glm::dot(glm::dvec3(light.axis), glm::dvec3(place)) + double{light.axis.w}) * over_w};
}

double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

void draw_triangle(const Corner& a, const Corner& b, const Corner& c, DepthMap& map) {
  const double area = side_of(a.at, b.at, c.at);
  if (!(std::abs(area) > 1e-12)) return;
  const glm::dvec2 low = glm::min(a.at, glm::min(b.at, c.at)), high = glm::max(a.at, glm::max(b.at, c.at));
  const auto texel = [&](double at) { return static_cast<int>(std::clamp(std::floor(at), -1.0, double(map.side))); };
  for (int y = std::max(0, texel(low.y)); y <= std::min(map.side - 1, texel(high.y)); ++y) {
    for (int x = std::max(0, texel(low.x)); x <= std::min(map.side - 1, texel(high.x)); ++x) {
      const glm::dvec2 middle(x + 0.5, y + 0.5);
      const double u = side_of(b.at, c.at, middle) / area, v = side_of(c.at, a.at, middle) / area, w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const double depth =
          (u * a.depth_over_w + v * b.depth_over_w + w * c.depth_over_w) / (u * a.over_w + v * b.over_w + w * c.over_w);
      float& nearest =
          map.depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.side) + static_cast<std::size_t>(x)];
      nearest = std::min(nearest, static_cast<float>(depth));
    }
  }
}

}  // namespace

DepthMap draw_depth_map(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                        const LightView& light, int side) {
  DepthMap map{side,
               std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), DepthMap::nowhere)};
  std::vector<Corner> corners;
  for (const glm::vec3& place : places) corners.push_back(corner_of(place, light, side));
  for (const glm::uvec3& t : triangles) {
    const Corner &a = corners[t.x], &b = corners[t.y], &c = corners[t.z];
    if (a.over_w > 0 && b.over_w > 0 && c.over_w > 0) draw_triangle(a, b, c, map);
  }
  return map;
}

}  // namespace pelage
