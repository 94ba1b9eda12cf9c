#version 450 core
#include "frame.glsl"
#include "lighting.glsl"

// One shell each: place with height, normal with the strands above, tangent with the strand's number, to eye, colour.
layout(binding = 0) uniform sampler2DArray cases;

uniform int asked;
uniform int light;  // whose shadow is asked for

layout(location = 0) out vec4 result;

vec4 given(int layer) { return texelFetch(cases, ivec3(gl_FragCoord.xy, layer), 0); }

void main() {
  Fibre fibre = Fibre(given(0).xyz, vec4(given(0).xyz, 0.0), given(1).xyz, given(2).xyz, given(3).xyz, given(4).rgb, colour_above(given(0).w),
                      given(0).w, given(1).w, given(2).w);
  result = vec4(0.0);
  if (asked == 0) result.rgb = fibre_light(fibre);
  if (asked == 1) result.rgb = transmittance(fibre.above, fibre.colour);
  if (asked == 2) result.rgb = environment_light(fibre.normal);
  if (asked == 3) {
    vec3 to_light, radiance;
    light_at(0, fibre.place, to_light, radiance);
    result = vec4(to_light, radiance.g);
  }
#ifdef SHADOW_MAPS
  if (asked == 6) {
    result.r = cast_light(light, fibre.place, fibre.open, fibre.normal);
    result.g = shell_depth(light, fibre.place, fibre.open, fibre.height, 1.0, 7.0);
  }
#endif
}
