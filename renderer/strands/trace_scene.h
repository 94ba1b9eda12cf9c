// What every ray of one picture shares.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shading/fibre_shading.h"
#include "renderer/strands/base_picture.h"
#include "renderer/strands/film.h"
#include "renderer/strands/lights.h"
#include "renderer/strands/sampler.h"
#include "renderer/strands/world.h"

namespace pelage {

/// What the base picture shows at a place of the picture.
struct BasePoint {
  bool there = false;
  float distance = 0;  // along the view, sizes
  glm::vec3 ambient{0}, direct{0}, albedo{0};
  glm::vec3 normal{0, 1, 0};
};

/// The look as traced strands have it.
Look traced_look(const FurFrame& frame);

/// A frame made ready to be traced. Safe to share between threads.
class TraceScene {
 public:
  TraceScene(const FurFrame& frame, BasePicture base);

  const FurFrame& frame() const { return frame_; }
  const StrandLights& lights() const { return lights_; }
  const FibreLobes& lobes() const { return lobes_; }
  float self_shadow() const { return self_shadow_; }  // optical depth of a black strand
  float brightest() const { return brightest_; }      // luminance that no sample's radiance passes

  /// Through a place of the picture, pixels from its top left corner.
  Ray ray_at(glm::vec2 place) const;
  float pixel_at(float distance) const;  // size of a pixel there, sizes
  BasePoint base_at(glm::vec2 place) const;
  /// Whether the ray comes near an eye, which the base picture knows better than the rays.
  bool near_eye(const Ray& ray) const;

  /// Scattered to the eye for light of radiance 1, as the look's model has it, averaged over the strand's width.
  glm::vec3 scatter(const Hit& hit, glm::vec3 to_light, glm::vec3 to_eye) const;
  const FibreShading& shading(float wetness) const;

 private:
  FurFrame frame_;
  BasePicture base_;
  StrandLights lights_;
  FibreLobes lobes_;
  ScatteringTable table_;
  std::vector<FibreShading> shadings_;  // by the wetness that is painted beyond the coat's own, in eighths
  float self_shadow_ = 1, brightest_ = 1;
};

}  // namespace pelage
