// Tufts (renderer/pattern/tufts.h): at height s strands have moved part of the distance to the middle of their tuft. So
// the strand that a ray hits is rooted further out, and beyond the border of a tuft there is none.
#include "constants.glsl"
layout(std140, binding = tuft_binding) uniform TuftBlock {
  vec4 origin;  // corner of the volume; w: share gathered at the tip
  vec4 scale;   // 1 / its extent; w: longest vector to a middle, sizes
} tufts;

layout(binding = tuft_unit) uniform sampler3D tuft_volume;

in vec3 tuft_root;
in float tuft_length;  // of the fur, sizes

struct Tuft {
  vec3 to_middle;
  float inside;
  float gather;  // share at the tip; a strand moves sideways by less than its length
};

Tuft tuft_here() {
  vec4 texel = textureLod(tuft_volume, (tuft_root - tufts.origin.xyz) * tufts.scale.xyz, 0.0);
  vec3 to_middle = (texel.rgb * 2.0 - 1.0) * tufts.scale.w;
  float radius = length(to_middle) / max(1.0 - texel.a, 0.05);
  return Tuft(to_middle, texel.a, tufts.origin.w * min(1.0, tuft_length / max(radius, 1e-4)));
}

float gathered(Tuft tuft, float s) { return tuft.gather * s * sqrt(s); }

// Returns the optical depth at a height, relative to fur without tufts: 0 beyond the border, higher inside.
float tuft_share(Tuft tuft, float s) {
  float remaining = 1.0 - gathered(tuft, s);
  return clamp(1.0 + (tuft.inside + remaining - 1.0) / 0.15, 0.0, 1.0) / remaining;
}

// Returns the vector along the surface from here to the root of the strand seen here at height s, sizes.
vec3 tuft_offset(Tuft tuft, float s) {
  float part = gathered(tuft, s);
  return -tuft.to_middle * (part / (1.0 - part));
}

// Returns the strand's slope towards the middle there, over its length.
vec3 tuft_lean(Tuft tuft, float s) {
  return tuft.to_middle * (1.5 * tuft.gather * sqrt(s) / (1.0 - gathered(tuft, s)) / max(tuft_length, 1e-4));
}
