#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "strip_light.glsl"
#include "fragment.glsl"

layout(binding = 1) uniform sampler2DArray colours;  // as fur.frag

uniform float least_opacity;

in vec2 tile;
in float across;
flat in float lightness;
in float reach;
in float strength;

const float local_mean = 5.0;  // level whose texels hold a few strands' colours

void main() {
  float opacity = strength * clamp(reach + 0.5 - abs(across), 0.0, 1.0);
  if (opacity < least_opacity) discard;
  int slice = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  vec3 strand = textureLod(colours, vec3(tile, float(slice)), local_mean).rgb;
  put_fragment(vec4(strip_light(strand * strand * lightness, 0.5) * opacity, opacity));
}
