#version 450 core
#include "fur_fragment.glsl"

in vec3 vertex_light;  // for fur of colour 1
#ifdef AOVS
in vec3 vertex_direct;
in vec2 vertex_share;
#endif

vec3 light_on(Fibre fibre) {
#ifdef AOVS
  direct_light = fibre.colour * vertex_direct;
  light_share = vertex_share;
#endif
  return fibre.colour * vertex_light;
}
