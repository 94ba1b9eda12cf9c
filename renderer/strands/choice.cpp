#include "renderer/strands/choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

float luminance(glm::vec3 colour) { return glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

void DiscreteDistribution::add(float weight) {
  assert(count_ < static_cast<int>(weights_.size()));
  weights_[static_cast<std::size_t>(count_)] = std::max(weight, 0.0f);
  total_ += weights_[static_cast<std::size_t>(count_++)];
}

DiscreteSample DiscreteDistribution::sample(float u) const {
  if (!(total_ > 0) || !std::isfinite(total_)) return {};
  float left = u * total_;
  int chosen = -1;  // rounding may pass the last: then the last that has a weight
  for (int i = 0; i < count_; ++i) {
    const float weight = weights_[static_cast<std::size_t>(i)];
    if (!(weight > 0)) continue;
    chosen = i;
    if (left < weight) break;
    left -= weight;
  }
  return {chosen, weights_[static_cast<std::size_t>(chosen)] / total_};
}

glm::vec3 any_across(glm::vec3 normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, axis));
}

glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 u) {
  const float radius = std::sqrt(u.x), angle = 2 * std::numbers::pi_v<float> * u.y;
  const glm::vec3 across = any_across(normal), up = glm::cross(normal, across);
  const glm::vec3 way = radius * (std::cos(angle) * across + std::sin(angle) * up) + std::sqrt(1 - u.x) * normal;
  return glm::normalize(way);
}

}  // namespace pelage
