#include "renderer/upload/set_cells.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

int cell_of(float clip) {
  return static_cast<int>(std::clamp((clip * 0.5f + 0.5f) * cells_a_side, 0.0f, cells_a_side - 1.0f));
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
  const BallBoxes balls(to_clip);
  std::vector<CellBox> boxes;
  boxes.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) boxes.push_back(cells_of(balls.of(positions[i], stretch * lengths[i])));
  return boxes;
}

BallBoxes::BallBoxes(const glm::mat4& to_clip) : to_clip_(to_clip) {
  const glm::mat4 rows = glm::transpose(to_clip);
  scale_ = {glm::length(glm::vec3(rows[0])), glm::length(glm::vec3(rows[1]))};
}

ClipBox BallBoxes::of(glm::vec3 centre, float radius) const {
  const glm::vec4 clip = to_clip_ * glm::vec4(centre, 1);
  const float nearest = clip.w - radius;
  if (!(nearest > 0)) return {};
  const glm::vec2 middle = glm::vec2(clip) / clip.w;
  const glm::vec2 reach = (scale_ + glm::abs(middle)) * (radius / nearest);
  const ClipBox box{middle - reach, middle + reach};
  return std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y) ? box : ClipBox{};
}

ClipBox union_of(const ClipBox& a, const ClipBox& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

ClipBox union_of(const std::optional<ClipBox>& a, const ClipBox& b) { return a ? union_of(*a, b) : b; }

CellBox cells_of(const ClipBox& box) {
  return {cell_of(box.low.x), cell_of(box.low.y), cell_of(box.high.x), cell_of(box.high.y)};
}

CellBox union_of(const CellBox& a, const CellBox& b) {
  return {std::min(a.left, b.left), std::min(a.low, b.low), std::max(a.right, b.right), std::max(a.high, b.high)};
}

CellBox union_of(const CellBox& a, const CellBox& b, const CellBox& c) { return union_of(union_of(a, b), c); }

bool touch(const CellBox& a, const CellBox& b) {
  return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
}

}  // namespace pelage
