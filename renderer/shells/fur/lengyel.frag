#version 450 core
#include "fur_fragment.glsl"

in vec3 vertex_light;  // for fur of colour 1

vec3 light_on(Fibre fibre, vec4 hull) {
  return fibre.colour * vertex_light;
}
