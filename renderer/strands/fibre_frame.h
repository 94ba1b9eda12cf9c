// The axes about a strand that renderer/shading/fibre_paths.h counts directions by.
#pragma once

#include <glm/glm.hpp>

#include "renderer/strands/sampling.h"

namespace pelage {

/// From tip to root, then across towards the eye, so that the eye's azimuth is 0.
class FibreFrame {
 public:
  /// Both unit; `tangent` from root to tip.
  FibreFrame(glm::vec3 tangent, glm::vec3 to_camera) : axis_(-tangent) {
    const glm::vec3 across = to_camera - axis_ * glm::dot(axis_, to_camera);
    const float length = glm::length(across);
    towards_ = length > 1e-6f ? across / length : any_across(axis_);  // along the strand there is no azimuth
    aside_ = glm::cross(axis_, towards_);
  }

  glm::vec3 local(glm::vec3 v) const { return {glm::dot(v, axis_), glm::dot(v, towards_), glm::dot(v, aside_)}; }
  glm::vec3 world(glm::vec3 v) const { return v.x * axis_ + v.y * towards_ + v.z * aside_; }

 private:
  glm::vec3 axis_, towards_, aside_;
};

}  // namespace pelage
