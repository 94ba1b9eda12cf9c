// Fur in parts of the view's depth, drawn from far to near, so that fur of what is near is blended over fur of what
// lies behind it. Within a part shells come in the order of their heights, which is that along a ray through one coat.
// A fragment belongs to a part by its own distance: no coat is torn where two parts meet.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

namespace pelage {

/// Two thirds of what eight bring to a koala, all that they bring to a creature from behind; eight draw a tenth longer.
inline constexpr int depth_part_count = 4;
/// Triangles of a model that is still drawn in parts: those of a large one cost more than its fragments.
inline constexpr std::size_t max_parted_triangles = 1 << 16;

/// Distances along the view, sizes: those from `nearest` on that are less than `furthest`.
struct DepthRange {
  float nearest = std::numeric_limits<float>::lowest(), furthest = std::numeric_limits<float>::max();

  bool holds(float distance) const { return distance >= nearest && distance < furthest; }
  /// The same as (begin, end] of one over a distance in front of the eye.
  float inverse_begin() const { return furthest > 0 ? 1 / furthest : std::numeric_limits<float>::max(); }
  float inverse_end() const { return nearest > 0 ? 1 / nearest : std::numeric_limits<float>::max(); }
};

/// `count` parts of one size over the depth of the skin, from far to near; the outer two have no end. One where the
/// skin has no depth.
std::vector<DepthRange> depth_parts(const glm::mat4& to_clip, std::span<const glm::vec3> positions, int count);

/// Least and largest distance along the view that the fur of each vertex may reach: a ball about the root, up to
/// `stretch` times as large as the fur is long.
std::vector<glm::vec2> distances_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                        std::span<const float> lengths, float stretch);

/// Those whose fur may be in a part.
std::vector<glm::uvec3> triangles_in(const DepthRange& part, std::span<const glm::vec2> distances,
                                     std::span<const glm::uvec3> triangles);

}  // namespace pelage
