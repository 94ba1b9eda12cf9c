// Pieces of fur from the camera inwards, for the depth of a frame: what a fragment adds to the opacity over its pixel, or, with
// CROSSING, one over its distance along the view where that opacity crosses half.
#include "constants.glsl"
#ifdef CROSSING
#include "inverse_distance.glsl"

layout(binding = covered_unit) uniform sampler2D covered;  // opacity after this piece, opacity before it

void keep_crossings() {
  vec2 opacity = texelFetch(covered, ivec2(gl_FragCoord.xy), 0).rg;
  if (opacity.r < 0.5 || opacity.g >= 0.5) discard;
}

vec4 covering(float opacity) { return vec4(inverse_distance(), 0.0, 0.0, 1.0); }
#else
vec4 covering(float opacity) { return vec4(opacity); }
#endif
