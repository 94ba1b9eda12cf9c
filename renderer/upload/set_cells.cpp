#include "renderer/upload/set_cells.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr CellBox everywhere;

int cell_of(float clip) {
  return static_cast<int>(std::clamp((clip * 0.5f + 0.5f) * cells_a_side, 0.0f, cells_a_side - 1.0f));
}

/// `scale` is how far a unit across the view moves on the picture at distance 1.
CellBox cells_of_ball(const glm::vec4& clip, glm::vec2 scale, float radius) {
  const float nearest = clip.w - radius;
  if (!(nearest > 0)) return everywhere;
  const glm::vec2 middle = glm::vec2(clip) / clip.w;
  const glm::vec2 reach = (scale + glm::abs(middle)) * (radius / nearest);
  const glm::vec2 low = middle - reach, high = middle + reach;
  if (!std::isfinite(low.x + low.y + high.x + high.y)) return everywhere;
  return {cell_of(low.x), cell_of(low.y), cell_of(high.x), cell_of(high.y)};
}

}  // namespace

void SetCells::show(const CellBox& box, int set) {
  for (int y = box.low; y <= box.high; ++y) {
    for (int x = box.left; x <= box.right; ++x)
      sets_[static_cast<std::size_t>(y * cells_a_side + x)] |= static_cast<std::uint8_t>(1 << set);
  }
}

bool SetCells::may_show(const CellBox& box, int set) const {
  for (int y = box.low; y <= box.high; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      if (sets_[static_cast<std::size_t>(y * cells_a_side + x)] >> set & 1) return true;
    }
  }
  return false;
}

std::vector<CellBox> cells_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                  std::span<const float> lengths, float stretch) {
  const glm::mat4 rows = glm::transpose(to_clip);
  const glm::vec2 scale(glm::length(glm::vec3(rows[0])), glm::length(glm::vec3(rows[1])));
  std::vector<CellBox> boxes;
  boxes.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    boxes.push_back(cells_of_ball(to_clip * glm::vec4(positions[i], 1), scale, stretch * lengths[i]));
  return boxes;
}

CellBox union_of(const CellBox& a, const CellBox& b) {
  return {std::min(a.left, b.left), std::min(a.low, b.low), std::max(a.right, b.right), std::max(a.high, b.high)};
}

CellBox union_of(const std::optional<CellBox>& a, const CellBox& b) { return a ? union_of(*a, b) : b; }

CellBox union_of(const CellBox& a, const CellBox& b, const CellBox& c) { return union_of(union_of(a, b), c); }

bool touch(const CellBox& a, const CellBox& b) {
  return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
}

}  // namespace pelage
