// The immutable data that all rays of one picture share.
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

/// The backplate at a position of the picture.
struct BackplatePixel {
  bool there = false;
  float distance = 0;  // along the view, sizes
  glm::vec3 ambient{0}, direct{0}, albedo{0};
  glm::vec3 normal{0, 1, 0};
};

/// A frame prepared for tracing. Safe to share between threads.
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
  Ray ray_at(glm::vec2 position) const;
  float pixel_at(float distance) const;  // width of a pixel at that distance, sizes
  BackplatePixel backplate_at(glm::vec2 position) const;
  /// Returns true if the ray passes near an eye; lids and cornea are only in the backplate.
  bool near_eye(const Ray& ray) const;

 private:
  FurFrame frame_;
  Backplate base_;
  StrandLights lights_;
  std::shared_ptr<const StrandShading> shading_;
  float self_shadow_ = 1, brightest_ = 1;
};

}  // namespace pelage
