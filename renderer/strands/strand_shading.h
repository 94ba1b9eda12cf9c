// The shading model for traced strands, made once and shared by many pictures.
#pragma once

#include <glm/glm.hpp>

#include "renderer/input/fur_scene.h"
#include "renderer/optics/one_strand.h"
#include "renderer/shading/fibre.h"
#include "renderer/strands/world.h"

namespace pelage {

/// Computes the light that strands scatter to the camera, for light of radiance 1, as renderer/optics/one_strand.h
/// does.
class StrandShading {
 public:
  explicit StrandShading(const FurFrame& frame);

  /// Returns true if it would be the same for that frame.
  bool fits(const FurFrame& frame) const;

  ShadingModel model() const { return look_.shading; }
  const FibreLobes& lobes() const { return lobes_; }
  /// Returns sigma_a for a strand of a linear colour; channels above 1 count as 1.
  glm::vec3 absorption(glm::vec3 colour) const;

  glm::vec3 scatter(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const;
  /// Returns what one fibre scatters, averaged over its width. Requires a fibre shading model.
  glm::vec3 scatter_once(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const;
  /// Returns what a bundle of fibres scatters, given what one fibre scatters (`once`).
  glm::vec3 scatter_bundle(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera, glm::vec3 once) const;

 private:
  Look look_;
  double wetness_;
  FibreLobes lobes_;
  StrandOptics optics_;
};

}  // namespace pelage
