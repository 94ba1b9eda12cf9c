// The fast lighting of traced strands: each sample traces one shadow ray to one light or into the environment, and the
// strands that it crosses attenuate the light by their colour and number (science.md 4, coloured transmittance). What a
// strand then scatters is computed as for shells (renderer/shaders/lighting.glsl), with the traced transmittance in
// place of the estimate.
#pragma once

#include "renderer/strands/film.h"
#include "renderer/strands/sampling.h"
#include "renderer/strands/trace_scene.h"

namespace pelage {

/// Traces a camera ray through a pixel position and lights its hit. `time` is Ray::time.
FilmSample transmitted_sample(const TraceScene& scene, const World& world, glm::vec2 position, float time,
                              Sampler& sampler);

/// The first hit of a camera ray; also used by paths.h.
struct CameraHit {
  Ray ray;
  Hit hit;              // none, a strand, or skin; eyes count as skin
  BackplatePixel base;  // backplate of skin and eyes
  bool eye = false;
  bool bare = false;  // skin without fur
};
CameraHit trace_camera_ray(const TraceScene& scene, const World& world, glm::vec2 position, float time);

/// Returns a sample with everything that does not depend on light: position, normal, tangent, albedo and others.
FilmSample features_of(const TraceScene& scene, const CameraHit& seen);

/// Lights skin and eyes: takes their light from the backplate and attenuates it by the fur and body on the way to one
/// light or into the environment.
void light_backplate(const TraceScene& scene, const World& world, const CameraHit& seen, Sampler& sampler,
                     FilmSample& sample);

/// Shades the ground if the ray hits it: shadows are black with an alpha.
void shade_ground(const TraceScene& scene, const World& world, const Ray& ray, Sampler& sampler, FilmSample& sample);

}  // namespace pelage
