// Small parts of sampling light: one of several by its weight, directions about a normal.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace pelage {

float luminance(glm::vec3 colour);

/// One of several, by its weight.
struct Choice {
  int index = -1;  // -1 where there is none to choose
  float probability = 1;
};

/// Up to nine weights: those of lamps, then of the environment.
class Chances {
 public:
  void add(float weight);        // below 0 counts as 0
  Choice choose(float u) const;  // u in [0, 1)

 private:
  std::array<float, 9> weights_{};
  int count_ = 0;
  float total_ = 0;
};

/// A unit vector across a unit normal.
glm::vec3 any_across(glm::vec3 normal);

/// A direction about a unit normal whose density is the cosine to it over pi; u in [0, 1)^2.
glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 u);

}  // namespace pelage
