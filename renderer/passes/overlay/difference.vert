#version 450 core
// The skin with how much the fields have changed at its vertices.
#include "frame.glsl"

layout(location = 0) in vec3 position;

layout(std430, binding = pass_storage) readonly buffer ShareBuffer { float values[]; } share_buffer;  // [0, 1]

out float share;

void main() {
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
  share = share_buffer.values[gl_VertexID];
}
