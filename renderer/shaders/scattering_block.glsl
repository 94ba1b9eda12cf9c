// The fibre parameters of a look. The caller binds ScatteringBlock of renderer/shading/scattering_table.h.
#include "constants.glsl"
#include "dialect.glsl"
#include "shared/strand.glsl"
layout(std140, binding = scattering_binding) uniform ScatteringBlock {
  ivec4 model;       // number of the model; 1 if the absorption is given
  vec4 weights;      // diffuse, specular, secondary specular, shift spread
  vec4 exponents;    // diffuse, specular, secondary; from colour to absorption coordinate
  vec4 shifts;       // primary, secondary
  vec4 absorption;   // absorption coordinates if they are given
  vec4 tilt_sine;    // for each lobe: R, TT, TRT, residual
  vec4 tilt_cosine;
  vec4 centre;       // theta_h of the peak
  vec4 over_variance;
  vec4 normaliser;
} scattering;
