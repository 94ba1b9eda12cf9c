#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#include "scattering.glsl"

// One shell each: tangent, normal, to light, to eye, colour with the strand's number.
layout(binding = 0) uniform sampler2DArray cases;

uniform int by_lobe;  // 1: M Ap Np of R, TT, TRT and the rest for the red channel

layout(location = 0) out vec4 result;

vec4 given(int layer) { return texelFetch(cases, ivec3(gl_FragCoord.xy, layer), 0); }

vec4 lobes(int model, vec3 tangent, vec3 to_light, vec3 to_camera, vec3 colour) {
  float sine_light = -dot(tangent, to_light), sine_view = -dot(tangent, to_camera), cos_theta = sine_to(sine_view);
  vec4 m = model == model_marschner ? marschner_longitudinal(sine_light, sine_view, cos_theta)
                                    : longitudinal_lobes(sine_light, sine_view);
  return m * azimuthal_lobes(azimuth_between(tangent, to_light, to_camera), cos_theta, absorption_coordinates(colour).r);
}

void main() {  // rgb: scattered light, a: B with a reach of a half
  int model = scattering.model.x;
  vec3 normal = given(1).xyz, to_light = given(2).xyz;
  result.rgb = scatter(model, given(0).xyz, normal, to_light, given(3).xyz, given(4).rgb, given(4).a);
  result.a = light_behind(model, dot(normal, to_light), 0.5);
  if (by_lobe == 1) result = lobes(model, given(0).xyz, to_light, given(3).xyz, given(4).rgb);
}
