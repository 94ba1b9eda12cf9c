#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#include "scattering.glsl"

// By array index: 0 tangent; 1 normal; 2 direction to the light; 3 direction to the camera; 4 colour, strand number.
layout(binding = 0) uniform sampler2DArray cases;

uniform int by_lobe;  // 1: M Ap Np of R, TT, TRT and the remaining lobe for the red channel

layout(location = 0) out vec4 result;

vec4 given(int layer) { return texelFetch(cases, ivec3(gl_FragCoord.xy, layer), 0); }

// Scattering of a single fibre, without what the bundle adds.
vec3 once(int model, Fibre fibre, vec3 to_light) {
  FibreViewTerms view_terms = fibre_view_terms(fibre);
  return scatters_fibres(model) ? scatter_fibre(fibre, view_terms, to_light, model == model_marschner)
                                : scatter(model, fibre, view_terms, to_light);
}

vec4 lobes(int model, Fibre fibre, vec3 to_light) {
  FibreViewTerms view_terms = fibre_view_terms(fibre);
  float sine_light = -dot(fibre.tangent, to_light), cos_theta = view_terms.cosine;
  if (model == model_marschner) cos_theta = cos_half_difference(sine_light, view_terms.sine);
  vec4 m = model == model_marschner ? marschner_lobes(sine_light, view_terms.sine, cos_theta) : longitudinal_lobes(sine_light, view_terms);
  return m * azimuthal_lobes(azimuth_between(fibre.tangent, view_terms.aside, to_light), cos_theta, view_terms.absorption.r);
}

void main() {  // rgb: scattered light, a: B with a reach of a half
  int model = scattering.model.x;
  vec3 none = vec3(0.0), to_light = given(2).xyz;
  Fibre fibre = Fibre(none, given(1).xyz, given(0).xyz, given(3).xyz, given(4).rgb, none, 0.0, 0.0, given(4).a, shine);
  result.rgb = once(model, fibre, to_light);
  result.a = backlight_fade(model, dot(fibre.normal, to_light), 0.5);
  if (by_lobe == 1) result = lobes(model, fibre, to_light);
}
