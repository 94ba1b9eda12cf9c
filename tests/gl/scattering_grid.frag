#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#include "scattering.glsl"

// One layer each: tangent, normal, to light, to eye, colour with the strand's number.
layout(binding = 0) uniform sampler2DArray cases;

layout(location = 0) out vec4 result;

vec4 given(int layer) { return texelFetch(cases, ivec3(gl_FragCoord.xy, layer), 0); }

void main() {  // rgb: scattered light, a: B with a reach of a half
  int model = scattering.model.x;
  vec3 normal = given(1).xyz, to_light = given(2).xyz;
  result.rgb = scatter(model, given(0).xyz, normal, to_light, given(3).xyz, given(4).rgb, given(4).a);
  result.a = light_behind(model, dot(normal, to_light), 0.5);
}
