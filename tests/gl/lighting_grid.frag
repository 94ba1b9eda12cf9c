#version 450 core
#include "frame.glsl"
#include "lighting.glsl"

// By array index: 0 position, height; 1 normal, strands above; 2 tangent, strand number; 3 direction to the camera; 4
// colour.
layout(binding = 0) uniform sampler2DArray cases;

uniform int asked;
uniform int light;  // index of the light whose shadow is asked for

layout(location = 0) out vec4 result;

vec4 given(int layer) { return texelFetch(cases, ivec3(gl_FragCoord.xy, layer), 0); }

void main() {
  vec3 position = given(0).xyz, colour = given(4).rgb;
  float height = given(0).w;
  vec4 hull = vec4(position, 0.0);
  Fibre fibre = Fibre(position, given(1).xyz, given(2).xyz, given(3).xyz, colour, colour_crossed(colour, colour_above(height)),
                      height, given(1).w, given(2).w, shine);
  result = vec4(0.0);
  if (asked == 0) result.rgb = fibre_light(fibre, hull);
  if (asked == 1) result.rgb = transmittance(fibre.above, fibre.colour);
  if (asked == 2) result.rgb = environment_light(fibre.normal);
  if (asked == 3) {
    Arriving arriving = light_at(0, fibre.position);
    result = vec4(arriving.to_light, arriving.radiance.g);
  }
#ifdef SHADOW_MAPS
  if (asked == 6) {
    result.r = cast_visibility(light, fibre.position, hull, fibre.normal);
    result.g = shell_depth(light, fibre.position, hull, fibre.height, 1.0, 7.0);
  }
#endif
}
