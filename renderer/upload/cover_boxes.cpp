#include "renderer/upload/cover_boxes.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace pelage {

namespace {

constexpr std::size_t most_sorted = 8192;  // more boxes are so many that most of the picture has changed
constexpr float least_gain = 0.012f;       // of area, where the picture has 4: a part more costs its draw calls

float area_of(const ClipBox& box) {
  const glm::vec2 size = glm::max(glm::min(box.high, glm::vec2(1)) - glm::max(box.low, glm::vec2(-1)), glm::vec2(0));
  return size.x * size.y;
}

ClipBox union_of(std::span<const ClipBox> boxes) {
  ClipBox all = boxes.front();
  for (const ClipBox& box : boxes) all = pelage::union_of(all, box);
  return all;
}

/// The first `left` of the boxes apart from the others, in the order of one axis.
struct Cut {
  std::size_t left = 0;
  int axis = 0;
  float gain = 0;  // of area
};

void order(std::span<ClipBox> boxes, int axis) {
  std::sort(boxes.begin(), boxes.end(), [axis](const ClipBox& a, const ClipBox& b) {
    return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
  });
}

Cut best_cut(std::span<ClipBox> boxes) {
  Cut best;
  const float whole = area_of(union_of(boxes));
  std::vector<float> before(boxes.size());
  for (int axis = 0; axis < 2; ++axis) {
    order(boxes, axis);
    ClipBox growing = boxes.front();
    for (std::size_t i = 0; i < boxes.size(); ++i) before[i] = area_of(growing = pelage::union_of(growing, boxes[i]));
    growing = boxes.back();
    for (std::size_t i = boxes.size() - 1; i > 0; --i) {
      growing = pelage::union_of(growing, boxes[i]);
      const float gain = whole - before[i - 1] - area_of(growing);
      if (gain > best.gain) best = {i, axis, gain};
    }
  }
  return best;
}

}  // namespace

std::vector<ClipBox> cover(std::vector<ClipBox> boxes, std::size_t most) {
  assert(most > 0);
  if (boxes.empty()) return {};
  if (boxes.size() > most_sorted) return {union_of(boxes)};
  std::vector<std::span<ClipBox>> groups{boxes};
  while (groups.size() < most) {
    std::size_t chosen = 0;
    Cut best;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Cut cut = best_cut(groups[i]);
      if (cut.gain > best.gain) best = cut, chosen = i;
    }
    if (best.gain < least_gain) break;
    const std::span<ClipBox> group = groups[chosen];
    order(group, best.axis);
    groups[chosen] = group.first(best.left);
    groups.push_back(group.subspan(best.left));
  }
  std::vector<ClipBox> covers;
  for (const std::span<ClipBox> group : groups) covers.push_back(union_of(group));
  return covers;
}

}  // namespace pelage
