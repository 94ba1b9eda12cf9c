#version 450 core
#include "frame.glsl"

uniform float height;

out vec3 place;

void main() {  // a square of 8 sizes about the model
  place = vec3(gl_VertexID % 2 == 0 ? -4.0 : 4.0, height, gl_VertexID / 2 == 0 ? -4.0 : 4.0);
  gl_Position = frame.world_to_clip * vec4(place, 1.0);
}
