// Fur in parts of the view's depth, drawn from far to near, so that fur of what is near is blended over fur of what
// lies behind it. Within a part shells come in the order of their heights, which is that along a ray through one coat.
// A fragment belongs to a part by its own distance: no coat is torn where two parts meet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

/// Two thirds of what eight bring to a koala, all that they bring to a creature from behind; eight draw a tenth longer.
inline constexpr int depth_part_count = 4;
/// Triangles of a model that is still drawn in parts: each shell has lists of its own there.
inline constexpr std::size_t max_parted_triangles = 1 << 16;

/// Distances along the view, sizes: those from `nearest` on that are less than `furthest`.
struct DepthRange {
  float nearest = std::numeric_limits<float>::lowest(), furthest = std::numeric_limits<float>::max();

  bool holds(float distance) const { return distance >= nearest && distance < furthest; }
  /// The same as (begin, end] of one over a distance in front of the eye.
  float inverse_begin() const { return furthest > 0 ? 1 / furthest : std::numeric_limits<float>::max(); }
  float inverse_end() const { return nearest > 0 ? 1 / nearest : std::numeric_limits<float>::max(); }
};

/// `count` parts of one size over the depth of the skin, from far to near; the outer two have no end.
class DepthParts {
 public:
  DepthParts(const glm::mat4& to_clip, std::span<const glm::vec3> positions, int count);

  int count() const { return count_; }
  DepthRange range(int part) const;
  /// The part of a distance.
  int at(float distance) const;

 private:
  float boundary(int part) const { return furthest_ - size_ * static_cast<float>(part); }  // the far end

  int count_;
  float furthest_ = 0, size_ = 0;
};

/// Of vertices: position, unit normal and tangent, and as groom the direction in the tangent plane and the length.
struct StrandRoots {
  std::span<const glm::vec3> positions, normals, tangents, grooms;
};

/// Where strands go along the view: no less than what is drawn of them.
class StrandDepths {
 public:
  StrandDepths(const StrandRoots& roots, const Coat& coat, const glm::mat4& to_clip);

  /// Least and largest distance along the view of a triangle's shell, at heights in [0, 1] over its corners.
  glm::vec2 of(const glm::uvec3& triangle, glm::vec3 heights);

 private:
  static constexpr int pieces = 4;               // of a strand
  static constexpr float bend_of_piece = 0.03f;  // of its length at most, off the straight line
  struct Strand {
    bool known = false;
    std::array<float, pieces + 1> distances{};  // from the root to the tip
    float length = 0;
  };
  const Strand& strand(std::uint32_t vertex);

  StrandRoots roots_;
  const Coat& coat_;
  glm::vec4 along_;  // distance of a place: its product with (place, 1)
  std::vector<Strand> strands_;
};

/// One of `shells` shells; where vertices have levels of detail it lies there as they say
/// (renderer/visibility/shell_lod.h).
struct ShellHeights {
  int shell, shells;
  std::span<const float> lods;  // of vertices; none where all are 0

  /// Of the middle of the shell's slab over the corners of a triangle, in [0, 1].
  glm::vec3 over(const glm::uvec3& triangle) const;
};

/// For each part the triangles whose shell may be there.
std::vector<std::vector<glm::uvec3>> in_parts(const DepthParts& parts, StrandDepths& strands,
                                              std::span<const glm::uvec3> triangles, const ShellHeights& heights);

}  // namespace pelage
