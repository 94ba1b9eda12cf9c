#version 450 core
// Darkens the pixels that show the ground: renderer/raster/ground-inl.h. Darkness is computed at positions `apart` pixels
// apart and interpolated: it varies no faster than the grid's cells.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "../../shaders/dialect.glsl"
#include "scene.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = sums_storage) buffer Sums { vec4 sums[]; };  // a: transmittance
layout(std430, binding = sky_storage) readonly buffer Sky { float sky[]; };
#include "../../shaders/shared/strand.glsl"
#include "lights.glsl"

float sky_hidden_at(float first, int further) { return sky[uint(first) + uint(further)]; }
float light_radius(uint light) { return light_widths[light].x; }
bool is_directional(uint light) { return light_widths[light].y > 0.5; }
// Returns a point of a spiral that covers a disc evenly (Vogel 1979).
vec2 disc_tap(int tap) {
  float angle = 2.399963 * float(tap);
  return sqrt((float(tap) + 0.5) / float(ground_light_taps)) * vec2(cos(angle), sin(angle));
}
#include "../../shaders/shared/ground.glsl"

const uint apart = 4, side = tile_side / apart + 1;
shared float dark[side * side];
shared bool any_visible;

void main() {
  uint tile = gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x, lane = gl_LocalInvocationIndex;
  uint at = tile * tile_pixels + lane;
  vec4 sum = sums[at];
  if (lane == 0) any_visible = false;
  barrier();
  if (sum.a > min_visible) any_visible = true;
  barrier();
  if (!any_visible) return;
  vec2 corner = vec2(box.xy) + vec2(gl_WorkGroupID.xy * tile_side);
  if (lane < side * side) dark[lane] = ground_darkness(ray_through(corner + float(apart) * vec2(lane % side, lane / side)));
  barrier();
  vec2 position = (vec2(gl_LocalInvocationID.xy) + 0.5) / float(apart), share = fract(position);
  uint first = uint(position.y) * side + uint(position.x);
  float above = mix(dark[first], dark[first + 1], share.x), below = mix(dark[first + side], dark[first + side + 1], share.x);
  sums[at] = vec4(sum.rgb, sum.a * (1.0 - mix(above, below, share.y)));
}
