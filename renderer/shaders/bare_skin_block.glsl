// Regions of bare skin. Layout std140; renderer/upload/blocks.h mirrors it. renderer/skin has the same shapes in double
// precision, for the length of the fur.
#include "constants.glsl"
struct SkinEntry {
  vec4 across, up, along;  // rows of the map to the unit ball; w: softness, 1 / smallest radius, cosine of full facing
  vec4 centre;             // w: scatter
  vec4 facing;             // unit; w: cosine below which there is nothing of the region
  vec4 colour;             // w: shine
  vec4 finish;             // roughness, wetness, height and size of the bumps
};

layout(std140, binding = skin_binding) uniform SkinBlock {
  uvec4 count;
  vec4 balls[max_skin_regions];          // bounding sphere of all that a region colours: centre, square of the radius
  SkinEntry regions[max_skin_regions];
} bare_skin;

vec3 point_in_cell(vec3 cell) {  // pcg3d (Jarzynski and Olano 2020)
  uvec3 v = uvec3(ivec3(cell)) * 1664525u + 1013904223u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}

#include "shared/skin.glsl"
#include "shared/bare_skin.glsl"
