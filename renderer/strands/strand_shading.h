// The look's shading model as traced strands ask for it, made once for many pictures.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shading/fibre_shading.h"
#include "renderer/strands/world.h"

namespace pelage {

class StrandShading {
 public:
  explicit StrandShading(const FurFrame& frame);

  /// Whether it would be the same for that frame.
  bool fits(const FurFrame& frame) const;

  ShadingModel model() const { return look_.shading; }
  const FibreLobes& lobes() const { return lobes_; }
  /// sigma_a of a strand of that linear colour, what is over 1 counts as 1.
  glm::vec3 absorption(glm::vec3 colour) const;
  /// Scattered to the eye for light of radiance 1, as FibreShading::scatter: fibre models averaged over the width.
  glm::vec3 scatter(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const;
  /// The same by energy_conserving, for a strand whose sigma_a is known.
  glm::vec3 scatter_averaged(const Hit& hit, glm::vec3 sigma_a, glm::vec3 to_light, glm::vec3 to_camera) const;

 private:
  Look look_;
  double wetness_;
  FibreLobes lobes_;
  ScatteringTable table_;
  std::vector<FibreShading> shadings_;  // by the wetness that is painted beyond the coat's own
};

}  // namespace pelage
