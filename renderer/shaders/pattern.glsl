#include "constants.glsl"
#include "luminance.glsl"

// Markings on the body: shares of three colours, read from a volume around the surface
// (renderer/pattern/surface_volume.h) and mixed as with_weights in renderer/pattern/pattern.cpp does.
layout(std140, binding = pattern_binding) uniform PatternColours {
  vec4 colour, inner_colour, belly_colour;
  vec4 origin;  // corner of the volume; w: 1 / largest luminance of the ramp
  vec4 scale;   // 1 / its extent
} pattern;

layout(binding = pattern_unit) uniform sampler3D pattern_volume;

vec3 with_weights(vec3 weights, vec3 base) {
  float shade = 0.36 + 0.84 * luminance(base) * pattern.origin.w;
  vec3 colour = mix(base, pattern.belly_colour.rgb * shade, weights.x);
  colour = mix(colour, pattern.inner_colour.rgb * shade, weights.y);
  return mix(colour, pattern.colour.rgb * shade, weights.z);
}

// Returns the colour of a strand whose root is at `root` and whose colour without a pattern is `base`. `varied` is the
// slow variation at the root: length, lean, factor on the lightness, shift of the hue.
vec3 pattern_colour(vec3 root, vec4 varied, vec3 base) {
  vec3 weights = textureLod(pattern_volume, (root - pattern.origin.xyz) * pattern.scale.xyz, 0.0).rgb;
  return with_weights(weights, base) * varied.z * vec3(1.0 + varied.w, 1.0, 1.0 - varied.w);
}
