// Light on one strand, for ray tracing: computed by the SIMD code that also draws fur (scattering-inl.h).
#pragma once

#include <glm/glm.hpp>

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/shading/scattering_table.h"

namespace pelage {

/// The shading model of a look for single strands, made once for many.
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
  float number = 0;   // random number of the strand, [0, 1]
  float wetness = 0;  // painted beyond the coat's own, [0, 1]
};

// Functions return the light scattered to the camera for light of radiance 1, for which a white matt surface would
// return 1: three channels, finite and >= 0. Shadow and ambient light are left to the caller. The same bits on one kind
// of CPU. Safe to share between threads.

/// Returns what the look's model scatters, including the attenuation of light from behind the surface (B of GPU fur eq
/// 1).
glm::vec3 scatter_strand(const StrandOptics& optics, const LitStrand& strand);

/// Returns what one fibre scatters, averaged over its width: pi times the sum of Mp Ap Np. Requires a fibre shading
/// model.
glm::vec3 scatter_once(const StrandOptics& optics, const LitStrand& strand);

/// Returns what a bundle of fibres scatters, given what one fibre scatters (`once`).
glm::vec3 scatter_bundle(const StrandOptics& optics, const LitStrand& strand, glm::vec3 once);

}  // namespace pelage
