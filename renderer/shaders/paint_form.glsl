// Paint on the strands of slices: density, clumps and curls. Part of slab.glsl.
#include "constants.glsl"
#ifdef PAINT
const float finest_shared = 3.0;  // level from which a texel holds several strands

// Returns the share of the optical depth at a position that belongs to strands whose number is below the density.
// Numbers cannot be filtered (science.md 1), so each of the four texels counts as a whole; where texels hold several
// strands, the share is the density.
float strand_share(vec2 at, int slice, float sharp) {
  if (amounts.x >= 1.0) return 1.0;
  if (sharp >= finest_shared) return amounts.x;
  int lod = int(sharp);
  ivec2 size = textureSize(shapes, lod).xy;
  vec2 texel = at * vec2(size) - 0.5;
  ivec2 low = ivec2(floor(texel));
  vec2 part = texel - vec2(low);
  float all = 1e-6, remaining = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1);
    vec2 near = mix(1.0 - part, part, vec2(corner));
    ivec3 coordinates = ivec3((low + corner) & (size - 1), slice);
    float depth = near.x * near.y * texelFetch(shapes, coordinates, lod).a;
    all += depth;
    if (texelFetch(colours, coordinates, lod).a < amounts.x) remaining += depth;
  }
  return remaining / all;
}

layout(binding = clump_unit) uniform sampler2D clump_map;  // vector to the middle of the clump; depth inside of it; its pull

vec2 clump_middle = vec2(0.0);  // vector from here, tiles
float clump_gather = 0.0;       // share at the tip
vec2 clump_shift = vec2(0.0);   // vector to the root of the strand seen here, tiles

// Gathers strands to their clump on the tile, as tufts.glsl does on the body: the strand seen here at height s is
// rooted further out in its clump, and beyond the clump's border there is none. It fades out for clumps finer than
// pixels. Returns the factor on the optical depth.
float gather_to_clump(float s) {
  float own = paint_block.coat.x, water = min(own + amounts.z, 1.0) - own;  // the effect of `own` is in the tile
  float gather = max_clump_gather * min(forms.y + water_gathers * water, 1.0) * (1.0 - smoothstep(4.0, 6.0, level));
  if (gather <= 0.0) return 1.0;
  vec4 clump = textureLod(clump_map, tile, 0.0);
  clump_middle = (clump.rg * 2.0 - 1.0) * paint_block.coat.w;
  clump_gather = gather * mix(0.5, 1.0, clump.a);
  float part = clump_gather * s * sqrt(s), remaining = 1.0 - part;
  clump_shift = -clump_middle * (part / remaining);
  return clamp(1.0 + (clump.b - part) / 0.15, 0.0, 1.0) / remaining;
}

// Returns the slope of strands towards the middle of their clump at height s, over the length that the tile was made
// for.
vec2 clump_slope(float s) {
  return clump_middle / frame.tile.x * (1.5 * clump_gather * sqrt(s) / (1.0 - clump_gather * s * sqrt(s)) / nominal_length);
}

// Returns the angle of painted curls at height s. The phase varies so slowly over the tile that neighbouring strands
// curl together and do not cross.
float curl_angle(float s) {
  vec2 angles = 6.2831853 * tile;
  return 6.2831853 * paint_block.coat.z * s + 2.2 * (sin(angles.x + 0.7) + sin(angles.y + 2.1));
}

// Returns the radius that paint adds to the coat's own curl, sizes; their sum is limited to max_curl.
float curl_radius() {
  float own = paint_block.coat.y;
  return max(min(own + forms.x, max_curl) - own, 0.0) * nominal_length;
}

// Returns the offset of a strand from its root at height s, sizes; the curl widens from the root as in
// renderer/coat/strand_tile.cpp.
vec2 curl_offset(float s) {
  if (forms.x <= 0.0) return vec2(0.0);
  float angle = curl_angle(s);
  return curl_radius() * min(1.0, 4.0 * s) * vec2(cos(angle), sin(angle));
}

// Returns the derivative of that by the height, over the length that the tile was made for.
vec2 curl_slope(float s) {
  if (forms.x <= 0.0) return vec2(0.0);
  float angle = curl_angle(s), turning = 6.2831853 * paint_block.coat.z * min(1.0, 4.0 * s);
  return curl_radius() / nominal_length * turning * vec2(-sin(angle), cos(angle));
}
#endif
