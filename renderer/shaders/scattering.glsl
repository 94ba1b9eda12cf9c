// The shading models of shared/scattering.glsl for shells; tests/gl compares them with renderer/shading on a grid. For
// the two fibre models, the caller binds the table of scattering_table.h as a 3D texture of RGBA32F, linear, clamped to
// its edges.
#include "scattering_block.glsl"

layout(binding = scattering_unit) uniform sampler3D azimuthal_table;  // by azimuth coordinate, cos theta, absorption; R, TT, TRT, residual

Shine shine = Shine(1.0, 1.0);  // set by painted water

// Returns the average of Ap Np over the fibre's width, for each lobe. The first and last texels lie at the ends of each
// range.
vec4 azimuthal_lobes(float azimuth, float cos_theta, float absorption) {
  vec3 at = clamp(vec3(azimuth, cos_theta, absorption), 0.0, 1.0);
  vec3 size = vec3(textureSize(azimuthal_table, 0));
  return textureLod(azimuthal_table, (at * (size - 1.0) + 0.5) / size, 0.0);
}

vec3 azimuthal_light(vec4 along, float azimuth, float cos_theta, vec3 absorption) {
  return vec3(dot(along, azimuthal_lobes(azimuth, cos_theta, absorption.r)),
              dot(along, azimuthal_lobes(azimuth, cos_theta, absorption.g)),
              dot(along, azimuthal_lobes(azimuth, cos_theta, absorption.b)));
}

#include "shared/scattering.glsl"
