// energy_conserving for paths: evaluated fast in float, and sampled by its lobes (Chiang 2016; science.md 4). A
// direction is (sin theta, cos theta cos phi, cos theta sin phi) about the axis of fibre.h, from tip to root.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "renderer/shading/fibre.h"

namespace pelage {

struct FibreSample {
  glm::vec3 direction{1, 0, 0};  // where the light comes from
  glm::vec3 weight{0};           // value over pdf; never more than 1 but for rounding and the cuticle's tilt
  float pdf = 0;                 // 1 / steradian; 0 where no light comes
};

/// One fibre seen from one direction at one offset: worked out once, asked for many lights.
class FibrePaths {
 public:
  /// `eye` is unit, where the light goes; h in [-1, 1]; sigma_a >= 0 by channel.
  FibrePaths(const FibreLobes& lobes, glm::vec3 view, float h, glm::vec3 sigma_a);

  /// Sum of Mp Ap Np for light from a unit direction: the cosine is in it, 1 / steradian.
  glm::vec3 value(glm::vec3 light) const;
  float pdf(glm::vec3 light) const;  // of sample(), 1 / steradian
  /// u chooses the lobe and the azimuth, v the inclination; all in [0, 1).
  FibreSample sample(glm::vec2 u, glm::vec2 v) const;

 private:
  struct Lobe {
    glm::vec3 left{0};            // Ap
    float share = 0;              // of the samples
    double sine = 0, cosine = 1;  // of the eye's inclination, tilted by the cuticle
    double azimuth = 0;           // about which the light leaves, [-pi, pi]
    double variance = 1;
    float over_variance = 1;
    float normal = 1;  // factor of Mp
  };

  std::array<float, lobe_count> shapes(glm::vec3 light) const;  // Mp Np
  std::size_t choose(float u) const;
  glm::vec3 direction_of(std::size_t p, float u, glm::vec2 v) const;

  std::array<Lobe, lobe_count> lobes_;
  double scale_ = 1;
  float over_scale_ = 1, logistic_normal_ = 1;
};

}  // namespace pelage
