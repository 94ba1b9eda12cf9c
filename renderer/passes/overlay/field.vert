#version 450 core
// The skin with the fields at its vertices.
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 7) in vec3 groom;  // direction (tangent, bitangent), length

layout(location = 11) in vec4 amounts;  // density, width, wetness, bare
layout(location = 12) in vec4 forms;    // curl, clump, mask

uniform float aspect;  // width over height

out vec2 lean;  // of the fur, as it shows: right and up, at most 1 where it lies across the view
out float fur_length;
out vec3 painted;  // density, wetness, mask

void main() {
  vec3 towards = tangent * groom.x + cross(normal, tangent) * groom.y;
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
  vec4 change = frame.world_to_clip * vec4(towards, 0.0);
  float near = frame.viewpoint.w * 1e-3;  // no division by what lies in the eye
  vec2 moved = (change.xy - gl_Position.xy / max(gl_Position.w, near) * change.w) * vec2(aspect, 1.0);
  float across = length(towards), shown = length(moved) / length(vec3(frame.world_to_clip[0].y, frame.world_to_clip[1].y, frame.world_to_clip[2].y));
  lean = across > 1e-6 && shown > 1e-9 ? moved / length(moved) * min(shown, across) : vec2(0.0);
  fur_length = groom.z;
  painted = vec3(amounts.xz, forms.z);
}
