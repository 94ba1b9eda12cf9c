#version 450 core
#include "frame.glsl"
#include "eye_block.glsl"

out vec3 local;         // on the box around the eye, in its frame
flat out vec3 viewer;   // in its frame
flat out int number;

const vec3 corners[8] = vec3[8](vec3(-1, -1, -1), vec3(1, -1, -1), vec3(-1, 1, -1), vec3(1, 1, -1),
                                vec3(-1, -1, 1), vec3(1, -1, 1), vec3(-1, 1, 1), vec3(1, 1, 1));
const int faces[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                              2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);

vec3 in_frame(Eye eye, vec3 v) { return vec3(dot(eye.right.xyz, v), dot(eye.up.xyz, v), dot(eye.forward.xyz, v)); }

void main() {
  number = gl_VertexID / 36;
  Eye eye = eyes[number];
  viewer = in_frame(eye, frame.viewpoint.xyz - eye.position.xyz) / eye.right.w;
  vec3 corner = corners[faces[gl_VertexID % 36]];
  float side = 1.02 * lid_radius, top = 1.02 * max(lid_radius, eye.cornea.x + eye.cornea.y);
  local = corner * vec3(side, side, corner.z > 0.0 ? top : side);
  vec3 place = eye.position.xyz +
               eye.right.w * (eye.right.xyz * local.x + eye.up.xyz * local.y + eye.forward.xyz * local.z);
  gl_Position = frame.world_to_clip * vec4(place, 1.0);
}
