// A discrete distribution over few weights, and directions about a normal.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace pelage {

float luminance(glm::vec3 colour);

/// What a discrete distribution was sampled to.
struct DiscreteSample {
  int index = -1;  // -1 where no weight is above 0
  float probability = 1;
};

/// Up to nine weights: those of the lights, then of the environment.
class DiscreteDistribution {
 public:
  void add(float weight);        // below 0 counts as 0
  DiscreteSample sample(float u) const;  // u in [0, 1)

 private:
  std::array<float, 9> weights_{};
  int count_ = 0;
  float total_ = 0;
};

/// A unit vector across a unit normal.
glm::vec3 any_across(glm::vec3 normal);

/// A direction about a unit normal whose pdf is the cosine to it over pi; u in [0, 1)^2.
glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 u);

}  // namespace pelage
