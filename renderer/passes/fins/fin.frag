#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "strip_light.glsl"
#include "fragment.glsl"

layout(binding = 11) uniform sampler2D side_view;  // colour times opacity, opacity

in float along;
in float strength;

void main() {
  vec4 texel = texture(side_view, vec2(along, height));
  float opacity = 1.0 - pow(max(1.0 - texel.a, 1e-3), strength);
  if (opacity < 0.004) discard;
  put_fragment(vec4(strip_light(texel.rgb / texel.a, 0.5) * opacity, opacity));
}
