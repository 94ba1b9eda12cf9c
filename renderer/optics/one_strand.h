// Light on one strand, computed by the code that draws fur over lanes (scattering-inl.h): for rays, which hit strands
// one at a time.
#pragma once

#include <glm/glm.hpp>

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/shading/scattering_table.h"

namespace pelage {

/// A look's shading model as one strand needs it, made once for many.
struct StrandOptics {
  ScatteringBlock scattering;
  AzimuthalFit azimuthal;
  int model;      // ShadingModel
  float reach;    // how far around a surface model takes light from behind, (0, 1]
  float wetness;  // the coat's own, [0, 1]
};

/// A strand and a light. Directions are unit and point away from the strand, the tangent from root to tip.
struct LitStrand {
  glm::vec3 tangent, normal, to_camera, to_light;
  glm::vec3 colour;   // linear, [0, 1]
  float number = 0;   // of the strand, [0, 1]
  float wetness = 0;  // painted beyond the coat's own, [0, 1]
};

// Scattered to the camera for light of radiance 1, which a white matt surface would return as 1: three channels, finite
// and not below 0. Shadow and ambient are the caller's. The same bits on one kind of CPU. Safe to share between
// threads.

/// Returns what the look's model scatters, light from behind the surface included (B of GPU fur eq 1).
glm::vec3 scatter_strand(const StrandOptics& optics, const LitStrand& strand);

/// Returns what one fibre scatters, averaged over its width: pi times the sum of Mp Ap Np. The model has to be one of
/// fibres.
glm::vec3 scatter_once(const StrandOptics& optics, const LitStrand& strand);

/// What a bundle of fibres sends back where one of them sends back `once`.
glm::vec3 scatter_bundle(const StrandOptics& optics, const LitStrand& strand, glm::vec3 once);

}  // namespace pelage
