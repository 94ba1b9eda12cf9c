#version 450 core
// Reorders pixels from tile by tile to row by row, and turns transmittance into alpha. The Totals of BoxStages come before
// the pixels.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer Sums { vec4 sums[]; };
layout(std430, binding = 1) writeonly buffer Rows {
  uvec4 found;  // knots, lit points, entries
  vec4 rows[];
};
layout(std430, binding = 2) readonly buffer StrandKnots { uint first_knots[]; };
layout(std430, binding = 3) readonly buffer StrandPoints { uint first_points[]; };
layout(std430, binding = 4) readonly buffer TileEntries { uint tile_entries[]; };

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = box.zw - box.xy;
  if (at == ivec2(0)) found = uvec4(first_knots[strand_count], first_points[strand_count], tile_entries[tiles.x * tiles.y], 0);
  if (any(greaterThanEqual(at, size))) return;
  vec4 sum = sums[pixel_index(at)];
  rows[at.y * size.x + at.x] = vec4(sum.rgb, 1.0 - sum.a);
}
