#include "renderer/visibility/depth_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "protocol/base/lean_curve.h"
#include "renderer/visibility/shell_lod.h"

namespace pelage {

namespace {

constexpr float rounding = 1e-5f;  // between distances here and those of the GL, of 1 and the distance itself

/// The last row: what the GL divides by is the distance along the view.
glm::vec4 distance_row(const glm::mat4& to_clip) {
  return {to_clip[0][3], to_clip[1][3], to_clip[2][3], to_clip[3][3]};
}

}  // namespace

DepthParts::DepthParts(const glm::mat4& to_clip, std::span<const glm::vec3> positions, int count) : count_(count) {
  assert(count >= 1);
  const glm::vec4 along = distance_row(to_clip);
  float nearest = std::numeric_limits<float>::max();
  furthest_ = std::numeric_limits<float>::lowest();
  for (const glm::vec3& position : positions) {
    const float distance = glm::dot(along, glm::vec4(position, 1));
    nearest = std::min(nearest, distance), furthest_ = std::max(furthest_, distance);
  }
  size_ = std::max(0.0f, furthest_ - nearest) / static_cast<float>(count);
  if (size_ < rounding) count_ = 1;
}

DepthRange DepthParts::range(int part) const {
  DepthRange range;
  if (part > 0) range.furthest = boundary(part);
  if (part < count_ - 1) range.nearest = boundary(part + 1);
  return range;
}

int DepthParts::at(float distance) const {
  int part = count_ == 1
                 ? 0
                 : static_cast<int>(std::clamp((furthest_ - distance) / size_, 0.0f, static_cast<float>(count_ - 1)));
  while (part > 0 && distance >= range(part).furthest) --part;  // the quotient may be rounded over a boundary
  while (part < count_ - 1 && distance < range(part).nearest) ++part;
  return part;
}

StrandDepths::StrandDepths(const StrandRoots& roots, const Coat& coat, const glm::mat4& to_clip)
    : roots_(roots), coat_(coat), along_(distance_row(to_clip)), strands_(roots.positions.size()) {}

const StrandDepths::Strand& StrandDepths::strand(std::uint32_t vertex) {
  Strand& strand = strands_[vertex];
  if (strand.known) return strand;
  const glm::vec3 groom = roots_.grooms[vertex], normal = roots_.normals[vertex];
  const auto [inclination, lean] = lean_of(glm::vec2(groom), normal, roots_.tangents[vertex]);
  const float up_rate = glm::dot(glm::vec3(along_), normal), lean_rate = glm::dot(glm::vec3(along_), lean);
  strand.distances[0] = glm::dot(along_, glm::vec4(roots_.positions[vertex], 1));
  for (int i = 1; i <= pieces; ++i) {
    const LeanPoint at = lean_point(coat_.lean_curve, inclination, coat_.root_share, static_cast<double>(i) / pieces);
    strand.distances[static_cast<std::size_t>(i)] =
        strand.distances[0] +
        groom.z * (static_cast<float>(at.up) * up_rate + static_cast<float>(at.across) * lean_rate);
  }
  strand.length = groom.z, strand.known = true;
  return strand;
}

glm::vec2 StrandDepths::of(const glm::uvec3& triangle, glm::vec3 heights) {
  const float longer = static_cast<float>(coat_.variation.length);
  glm::vec2 range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (int corner = 0; corner < 3; ++corner) {
    const Strand& at = strand(triangle[corner]);
    const float height = heights[corner], place = height * pieces;
    const auto piece = static_cast<std::size_t>(std::min(place, pieces - 1.0f));
    // Other lengths move a place along its strand, other leans anywhere at its height.
    const float varied = coat_.variation.lean > 0 ? 2 * (1 + longer) * height : longer * height;
    const float distance = glm::mix(at.distances[piece], at.distances[piece + 1], place - static_cast<float>(piece));
    const float margin = at.length * (bend_of_piece * (1 + longer) + varied) + rounding * (1 + std::abs(distance));
    range = {std::min(range.x, distance - margin), std::max(range.y, distance + margin)};
  }
  return range;
}

glm::vec3 ShellHeights::over(const glm::uvec3& triangle) const {
  const auto middle = [&](float lod) {
    return 0.5f * (slab_begin(shell, shells, lod) + slab_begin(shell + 1, shells, lod)) / static_cast<float>(shells);
  };
  if (lods.empty()) return glm::vec3(middle(0));
  return {middle(lods[triangle.x]), middle(lods[triangle.y]), middle(lods[triangle.z])};
}

std::vector<std::vector<glm::uvec3>> in_parts(const DepthParts& parts, StrandDepths& strands,
                                              std::span<const glm::uvec3> triangles, const ShellHeights& heights) {
  std::vector<std::vector<glm::uvec3>> result(static_cast<std::size_t>(parts.count()));
  for (const glm::uvec3& triangle : triangles) {
    const glm::vec2 range = strands.of(triangle, heights.over(triangle));
    for (int part = parts.at(range.y); part <= parts.at(range.x); ++part)
      result[static_cast<std::size_t>(part)].push_back(triangle);
  }
  return result;
}

}  // namespace pelage
