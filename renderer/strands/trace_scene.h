// What every ray of one picture shares.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/film.h"
#include "renderer/strands/lights.h"
#include "renderer/strands/sampling.h"
#include "renderer/strands/strand_shading.h"
#include "renderer/strands/tracer.h"
#include "renderer/strands/world.h"

namespace pelage {

/// What the backplate shows at a place of the picture.
struct BackplatePixel {
  bool there = false;
  float distance = 0;  // along the view, sizes
  glm::vec3 ambient{0}, direct{0}, albedo{0};
  glm::vec3 normal{0, 1, 0};
};

/// A frame made ready to be traced. Safe to share between threads.
class TraceScene {
 public:
  TraceScene(const FurFrame& frame, Backplate base, std::shared_ptr<const StrandShading> shading);

  const FurFrame& frame() const { return frame_; }
  const StrandLights& lights() const { return lights_; }
  const StrandShading& shading() const { return *shading_; }
  std::size_t backplate_bytes() const;
  float self_shadow() const { return self_shadow_; }  // optical depth of a black strand
  float brightest() const { return brightest_; }      // upper bound of a sample's luminance

  /// Returns the ray through a position of the picture, in pixels from its top left corner.
  Ray ray_at(glm::vec2 place) const;
  float pixel_at(float distance) const;  // size of a pixel there, sizes
  BackplatePixel backplate_at(glm::vec2 place) const;
  /// Returns whether the ray comes near an eye, which the backplate knows better than the rays.
  bool near_eye(const Ray& ray) const;

 private:
  FurFrame frame_;
  Backplate base_;
  StrandLights lights_;
  std::shared_ptr<const StrandShading> shading_;
  float self_shadow_ = 1, brightest_ = 1;
};

}  // namespace pelage
