#version 450 core
// Fur from the eye inwards: its opacity, or, with CROSSING, one over its distance where that crosses half.
#include "frame.glsl"
#include "slab.glsl"

in float density_share;

uniform int step_count;  // texture steps inside the slab

#ifdef CROSSING
layout(binding = 1) uniform sampler2D covered;  // opacity after this shell, opacity before it
#endif

layout(location = 0) out vec4 result;

void main() {
#ifdef CROSSING
  vec2 opacity = texelFetch(covered, ivec2(gl_FragCoord.xy), 0).rg;
  if (opacity.r < 0.5 || opacity.g >= 0.5) discard;
#endif
  float own = march(step_count, 0.0, density_share).opacity;
  if (own * float(shell_count) < 0.02) discard;  // as fur.frag does
#ifdef CROSSING
  result = vec4(gl_FragCoord.w, 0.0, 0.0, 1.0);
#else
  result = vec4(own);
#endif
}
