#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 5) in vec3 image_uv;
layout(location = 6) in vec3 colour;
layout(location = 7) in vec3 groom;

out vec3 place;
out vec3 skin_normal;
out vec3 base_uv;
out vec3 base_colour;
out float fur_length;
#ifdef PATTERN
layout(location = 10) in vec4 variation;
out vec4 varied;
#endif

void main() {
  place = position;
  skin_normal = normal;
  base_uv = image_uv;
  base_colour = colour;
  fur_length = groom.z;
#ifdef PATTERN
  varied = variation;
#endif
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
}
