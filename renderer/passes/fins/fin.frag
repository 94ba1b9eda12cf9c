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

layout(binding = side_view_unit) uniform sampler2D side_view;  // colour times opacity, opacity

in float along;
in float strength;

void main() {
  vec4 texel = texture(side_view, vec2(along, height));
  float opacity = 1.0 - pow(max(1.0 - texel.a, 1e-3), strength);
  if (opacity < 0.004) discard;
#ifdef COVERING
#ifdef CROSSING
  keep_crossings();
#endif
  put_fragment(covering(opacity));
#else
  vec3 colour = strip_colour(texel.rgb / texel.a, 1.0);
  put_fragment(vec4(strip_light(colour, 0.5) * opacity, opacity));
#ifdef AOVS
  write_aovs(place, strip_normal(), strip_tangent(), colour, 0.0, opacity);
#endif
#endif
}
