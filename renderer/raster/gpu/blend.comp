#version 450 core
// Blends a tile's segments front to back, by their coverage of each pixel: renderer/raster/blend-inl.h, a pixel a lane.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "shown.glsl"
layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer TileEntries { uint tile_entries[]; };
layout(std430, binding = 1) readonly buffer Entries { uvec2 entries[]; };
layout(std430, binding = 2) readonly buffer Knots { uvec2 knots[]; };
layout(std430, binding = 3) readonly buffer Ends { float ends[]; };
layout(std430, binding = 4) writeonly buffer Sums { vec4 sums[]; };  // rgb: what is shown; a: transmittance

const uint together = 64;        // number of segments that a group loads at a time

// A segment over the tile, in pixels from the tile's corner.
struct FlatSegment {
  vec2 at, direction;  // start, and unit direction
  float over_reach, reach, half_width, more_half_width;
  float inverse, more_inverse, sharpness;
  uint knot, blocks;  // `blocks`: a bit for each block of the tile that it may touch
  vec3 light, more_light;
};
shared FlatSegment segments[together];
shared uint still_transparent;

// Returns the pixel of a lane. Each 32 lanes, which run together, draw a block of eight by four pixels, so that they can
// skip a segment together.
uvec2 pixel_of(uint lane) {
  uint block = lane / 32, in_block = lane % 32;
  return uvec2(block % 2 * 8 + in_block % 8, block / 2 * 4 + in_block / 8);
}

uint touched_blocks(vec2 a, vec2 b, float half_width) {
  float wide = max(half_width, 1.0) + 0.6;
  vec2 low = min(a, b) - wide, high = max(a, b) + wide;
  if (any(lessThanEqual(high, vec2(0.0))) || any(greaterThanEqual(low, vec2(tile_side)))) return 0;
  uvec2 first = uvec2(max(low, 0.0)) / uvec2(8, 4), last = uvec2(min(high, float(tile_side) - 1.0)) / uvec2(8, 4);
  uint blocks = 0;
  for (uint y = first.y; y <= last.y; ++y)
    for (uint x = first.x; x <= last.x; ++x) blocks |= 1u << (2 * y + x);
  return blocks;
}

FlatSegment flat_segment(uint knot, vec2 corner) {
  vec2 a = uintBitsToFloat(knots[3 * knot]), b = uintBitsToFloat(knots[3 * knot + 3]);
  vec2 of_a = uintBitsToFloat(knots[3 * knot + 1]), of_b = uintBitsToFloat(knots[3 * knot + 4]);
  uvec2 light_a = knots[3 * knot + 2], light_b = knots[3 * knot + 5];
  FlatSegment flattened;
  flattened.reach = sqrt(max(dot(b - a, b - a), 1e-8));
  flattened.over_reach = 1.0 / flattened.reach;
  flattened.at = a - corner;
  flattened.direction = (b - a) * flattened.over_reach;
  flattened.half_width = of_a.y;
  flattened.more_half_width = of_b.y - of_a.y;
  flattened.inverse = of_a.x;
  flattened.more_inverse = of_b.x - of_a.x;
  flattened.sharpness = clamp(8.0 * max(of_a.y, of_b.y) - 3.0, 1.0, 8.0);
  flattened.light = vec3(unpackHalf2x16(light_a.x), unpackHalf2x16(light_a.y).x);
  flattened.more_light = vec3(unpackHalf2x16(light_b.x), unpackHalf2x16(light_b.y).x) - flattened.light;
  flattened.knot = knot;
  flattened.blocks = touched_blocks(a - corner, b - corner, max(of_a.y, of_b.y));
  return flattened;
}

// Returns how much of a pixel a segment covers. `share` becomes the position along the segment, in [0, 1].
float covered_by(FlatSegment s, vec2 off, out float share) {
  float along = dot(off, s.direction), beside = abs(off.y * s.direction.x - off.x * s.direction.y);
  share = clamp(along * s.over_reach, 0.0, 1.0);
  float half_width = share * s.more_half_width + s.half_width, drawn = max(half_width, 1.0);
  float covered = clamp(drawn - beside + 0.5, 0.0, 1.0) - clamp(0.5 - drawn - beside, 0.0, 1.0);
  float within = clamp(along * s.sharpness + 0.5, 0.0, 1.0) - clamp((along - s.reach) * s.sharpness + 0.5, 0.0, 1.0);
  return min(covered * within * min(half_width, 1.0), 1.0);
}

// Returns the sum after a segment is added. `weight` is the segment's weight, `through` the transmittance in front of
// it.
vec3 added(vec3 sum, FlatSegment s, float share, float weight, float through) {
#if defined SHOWN_STRAND  // of the segment that covers most: knot | knot_bit, position along it, coverage
  return weight > sum.z ? vec3(uintBitsToFloat(knot_bit | s.knot), share, weight) : sum;
#elif defined SHOWN_DISTANCE
  return sum + vec3(weight / max(share * s.more_inverse + s.inverse, 1e-12), 0.0, 0.0);
#elif defined SHOWN_COUNT
  return sum + vec3(weight > 0.0 ? 1.0 : 0.0, 0.0, 0.0);
#elif defined SHOWN_DEPTH
  bool first = through >= 0.5 && through - weight < 0.5;
  return first ? vec3(share * s.more_inverse + s.inverse, sum.yz) : sum;
#else
  return sum + weight * (share * s.more_light + s.light);
#endif
}

void main() {
  uint tile = gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x, lane = gl_LocalInvocationIndex;
  uint first = tile_entries[tile], end = min(tile_entries[tile + 1], entry_capacity);
  uvec2 pixel = pixel_of(lane);
  vec2 corner = vec2(box.xy) + vec2(gl_WorkGroupID.xy * tile_side), at = vec2(pixel) + 0.5;
  uint own_block = 1u << lane / 32, index = tile * tile_pixels + pixel.y * tile_side + pixel.x;
  float behind = ends[index], through = 1.0;
  vec3 sum = vec3(0.0);
  for (uint begin = first; begin < end; begin += together) {
    uint count = min(together, end - begin);
    if (lane < count) segments[lane] = flat_segment(entries[begin + lane].y, corner);
    if (lane == 0) still_transparent = 0;
    barrier();
    for (uint i = 0; i < count; ++i) {
      if ((segments[i].blocks & own_block) == 0) continue;
      float share, alpha = covered_by(segments[i], at - segments[i].at, share);
      float inverse = share * segments[i].more_inverse + segments[i].inverse;
      float weight = inverse > behind ? alpha * through : 0.0;
      sum = added(sum, segments[i], share, weight, through);
      through -= weight;
    }
    if (through > min_transmittance) still_transparent = 1;
    barrier();
    if (still_transparent == 0) break;
    barrier();
  }
  sums[index] = vec4(sum, through);
}
