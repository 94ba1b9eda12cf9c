#include "renderer/frame/clip_box.h"

#include <cmath>

namespace pelage {

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

ClipBox union_of(const std::optional<ClipBox>& a, const ClipBox& b) {
  return a ? ClipBox{glm::min(a->low, b.low), glm::max(a->high, b.high)} : b;
}

}  // namespace pelage
