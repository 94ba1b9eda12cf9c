#include "renderer/visibility/picture_cells.h"

#include <algorithm>
#include <cmath>

#include "protocol/base/clamped_index.h"

namespace pelage {

namespace {

float place_of(float clip) { return (clip * 0.5f + 0.5f) * cells_a_side; }

/// -1 and cells_a_side outside of the picture.
int cell_of(float clip) { return clamped_index(std::floor(place_of(clip)), -1, cells_a_side); }

/// That a box ending here reaches.
int last_cell_of(float clip) { return clamped_index(std::ceil(place_of(clip)), -1, cells_a_side + 1) - 1; }

}  // namespace

std::vector<CellBox> cells_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                  std::span<const float> lengths, float stretch) {
  const BallBoxes balls(to_clip);
  std::vector<CellBox> boxes;
  boxes.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    boxes.push_back(cells_of(balls.of(positions[i], stretch * lengths[i])));
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
  const int left = cell_of(box.low.x), low = cell_of(box.low.y);
  return {left, low, std::max(left, last_cell_of(box.high.x)), std::max(low, last_cell_of(box.high.y))};
}

CellBox union_of(const CellBox& a, const CellBox& b) {
  return {std::min(a.left, b.left), std::min(a.low, b.low), std::max(a.right, b.right), std::max(a.high, b.high)};
}

CellBox union_of(const CellBox& a, const CellBox& b, const CellBox& c) { return union_of(union_of(a, b), c); }

bool touch(const CellBox& a, const CellBox& b) {
  return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
}

}  // namespace pelage
