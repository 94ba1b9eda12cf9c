// The fast lighting of traced strands: each sample follows one ray to one light, and the fur that it crosses leaves a
// transmittance by its colour and count (science.md 4, coloured transmittance). What a strand then scatters is computed
// as for shells (renderer/shaders/lighting.glsl), with crossings in place of the estimate.
#pragma once

#include "renderer/strands/film.h"
#include "renderer/strands/sampling.h"
#include "renderer/strands/trace_scene.h"

namespace pelage {

/// What a ray through a place of the picture sees, at a time as Ray has it.
FilmSample transmitted_sample(const TraceScene& scene, const World& world, glm::vec2 place, float time,
                              Sampler& sampler);

/// What a camera ray through a pixel position hits: shared with paths.
struct Seen {
  Ray ray;
  Hit hit;              // nothing, a strand, or skin
  BackplatePixel base;  // of skin and eyes
  bool eye = false;
  bool bare = false;  // skin without fur
};
Seen look_at(const TraceScene& scene, const World& world, glm::vec2 place, float time);

/// Position, normal, tangent and what else is not light.
FilmSample features_of(const TraceScene& scene, const Seen& seen);

/// Skin and eyes in the light that fur and body transmit to them: the backplate's, one light at a time.
void light_backplate(const TraceScene& scene, const World& world, const Seen& seen, Sampler& sampler,
                     FilmSample& sample);

/// Darkens the ground where the ray hits it: black with an alpha.
void shade_ground(const TraceScene& scene, const World& world, const Ray& ray, Sampler& sampler, FilmSample& sample);

}  // namespace pelage
