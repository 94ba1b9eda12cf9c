#version 450 core
#include "frame.glsl"
#include "lean.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 15) in vec3 shading_normal;
layout(location = 5) in vec3 image_uv;
layout(location = 6) in vec3 colour;
layout(location = 7) in vec3 groom;

#include "paint_attributes.glsl"

out vec3 world_position;
out vec3 skin_normal;
out vec3 base_uv;
out vec3 base_colour;
out float fur_length;
#ifdef PATTERN
layout(location = 10) in vec4 variation;
out vec4 varied;
#endif
layout(location = 2) in vec3 tangent;
out vec3 fur_offset;  // from the root to the hull of the fur
#ifdef SHADOW_MAPS
out vec4 hull_position;  // xyz: hull position, where light that passes the rest of the body reaches the fur; w: height of the hull
#endif

void main() {
  world_position = position;
  fur_offset = hull_offset(groom, normal, tangent, frame.tile.z > 0.5, frame.counts.w, 0.0);
#ifdef HULL
  world_position += fur_offset;
#endif
#ifdef SHADOW_MAPS
  hull_position = vec4(position + fur_offset, hull_height * groom.z);
#endif
  skin_normal = shading_normal;
  base_uv = image_uv;
  base_colour = colour;
  fur_length = groom.z;
  hand_on_paint();
#ifdef PATTERN
  varied = variation;
#endif
  gl_Position = frame.world_to_clip * vec4(world_position, 1.0);
}
