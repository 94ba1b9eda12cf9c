#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "strip_light.glsl"
#include "fragment.glsl"
#ifdef AOVS
#include "aovs.glsl"
#endif
#ifdef COVERING
#include "covering.glsl"
#endif

layout(binding = colours_unit) uniform sampler2DArray colours;  // as slab.glsl

uniform float min_opacity;

in vec2 tile;
in float across;
flat in float lightness;
in float reach;
in float strength;

const float local_mean = 5.0;  // level whose texels hold a few strands' colours

void main() {
  float opacity = strength * clamp(reach + 0.5 - abs(across), 0.0, 1.0);
  if (opacity < min_opacity) discard;
#ifdef COVERING
#ifdef CROSSING
  keep_crossings();
#endif
  put_fragment(covering(opacity));
#else
  int slice = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  vec3 strand = textureLod(colours, vec3(tile, float(slice)), local_mean).rgb;
  vec3 colour = strip_colour(strand * strand * lightness, lightness);
  put_fragment(vec4(strip_light(colour, 0.5) * opacity, opacity));
#ifdef AOVS
  write_aovs(place, strip_normal(), strip_tangent(), colour, 0.0, opacity);
#endif
#endif
}
