#version 450 core
#include "frame.glsl"
#include "lean.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 tile_uv;
layout(location = 4) in vec3 tile_axis;
layout(location = 5) in vec3 image_uv;
layout(location = 6) in vec3 colour;
layout(location = 7) in vec3 groom;

uniform int shell;

out vec3 place, fibre_normal, fibre_tangent, tile_u, base_uv, base_colour;
out vec2 tile;
out float height;

void main() {
  height = (float(shell) + 0.5) / frame.counts.x;
  float inclination = min(length(groom.xy), 1.0);
  vec2 heading = inclination > 1e-6 ? groom.xy / inclination : vec2(1.0, 0.0);
  vec3 lean = tangent * heading.x + cross(normal, tangent) * heading.y;
  vec3 curve = lean_point(frame.tile.z > 0.5, inclination, frame.counts.w, height);
  place = position + groom.z * (curve.x * lean + curve.y * normal);
  fibre_normal = normal;
  fibre_tangent = lean * sin(curve.z) + normal * cos(curve.z);
  tile = tile_uv * frame.tile.x;
  tile_u = tile_axis;
  base_uv = image_uv;
  base_colour = colour;
  gl_Position = frame.world_to_clip * vec4(place, 1.0);
}
