// energy_conserving for paths: evaluated fast in float, and sampled by its lobes (Chiang 2016; science.md 4). A direction
// is (sin theta, cos theta cos phi, cos theta sin phi) about the axis of fibre.h, from tip to root.
#pragma once

#include <glm/glm.hpp>

#include "renderer/shading/fibre.h"

namespace pelage {

struct FibreSample {
  glm::vec3 direction{1, 0, 0};  // where the light comes from
  glm::vec3 weight{0};           // value over density; never more than 1 but for rounding and the cuticle's tilt
  float density = 0;             // 1 / steradian; 0 where no light comes
};

/// One fibre seen from one direction at one offset: worked out once, asked for many lights.
class FibrePaths {
 public:
  /// `eye` is unit, where the light goes; h in [-1, 1]; sigma_a >= 0 by channel.
  FibrePaths(const FibreLobes& lobes, glm::vec3 eye, float h, glm::vec3 sigma_a);

  /// Sum of Mp Ap Np for light from a unit direction: the cosine is in it, 1 / steradian.
  glm::vec3 value(glm::vec3 light) const;
  float density(glm::vec3 light) const;  // of sample(), 1 / steradian
  FibreSample sample(glm::vec2 u, glm::vec2 v) const;
};

}  // namespace pelage
