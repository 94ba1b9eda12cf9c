#version 450 core
// Quads over the whole picture, one for each instance, in any order.
layout(std430, binding = 0) readonly buffer Quads { vec4 quads[]; };  // depth, grey, opacity

flat out vec4 quad;

void main() {
  quad = quads[gl_InstanceID];
  gl_Position = vec4(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID / 2 == 0 ? -1.0 : 1.0, quad.x, 1.0);
}
