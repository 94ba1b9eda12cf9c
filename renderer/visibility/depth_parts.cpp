#include "renderer/visibility/depth_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace pelage {

namespace {

constexpr float rounding = 1e-5f;  // between distances here and those of the GL, of 1 and the distance itself

/// The last row: what the GL divides by is the distance along the view.
glm::vec4 distance_row(const glm::mat4& to_clip) {
  return {to_clip[0][3], to_clip[1][3], to_clip[2][3], to_clip[3][3]};
}

}  // namespace

std::vector<DepthRange> depth_parts(const glm::mat4& to_clip, std::span<const glm::vec3> positions, int count) {
  assert(count >= 1);
  const glm::vec4 along = distance_row(to_clip);
  float nearest = std::numeric_limits<float>::max(), furthest = std::numeric_limits<float>::lowest();
  for (const glm::vec3& position : positions) {
    const float distance = glm::dot(along, glm::vec4(position, 1));
    nearest = std::min(nearest, distance), furthest = std::max(furthest, distance);
  }
  const float size = std::max(0.0f, furthest - nearest) / static_cast<float>(count);
  std::vector<DepthRange> parts(1);
  for (int part = 1; part < count && size >= rounding; ++part) {
    parts.back().nearest = furthest - size * static_cast<float>(part);
    parts.push_back({.furthest = parts.back().nearest});
  }
  return parts;
}

std::vector<glm::vec2> distances_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                        std::span<const float> lengths, float stretch) {
  const glm::vec4 along = distance_row(to_clip);
  std::vector<glm::vec2> distances;
  distances.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float distance = glm::dot(along, glm::vec4(positions[i], 1));
    const float reach = stretch * lengths[i] + rounding * (1 + std::abs(distance));
    distances.emplace_back(distance - reach, distance + reach);
  }
  return distances;
}

std::vector<glm::uvec3> triangles_in(const DepthRange& part, std::span<const glm::vec2> distances,
                                     std::span<const glm::uvec3> triangles) {
  std::vector<glm::uvec3> inside;
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(inside), [&](const glm::uvec3& t) {
    const glm::vec2 a = distances[t.x], b = distances[t.y], c = distances[t.z];
    return std::max({a.y, b.y, c.y}) >= part.nearest && std::min({a.x, b.x, c.x}) < part.furthest;
  });
  return inside;
}

}  // namespace pelage
