#version 450 core
// Sorts segments of strands into tiles (renderer/raster/bins.cpp). The first pass counts those of each tile, the second
// writes them.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer StrandKnots { uint first_knots[]; };
layout(std430, binding = 1) readonly buffer Knots { uvec2 knots[]; };
layout(std430, binding = 2) readonly buffer Furthest { float furthest[]; };  // for each tile, 1 / the furthest distance behind its strands
layout(std430, binding = 3) buffer TileCounts { uint tile_counts[]; };       // segments of each tile; see BoxStages::fill_tiles
layout(std430, binding = 4) buffer TileEntries { uint tile_entries[]; };     // index of each tile's first entry; read when `writing`
layout(std430, binding = 5) writeonly buffer Entries { uvec2 entries[]; };   // sort key, first knot of the segment
uniform bool writing;

Knot read_knot(uint knot) {
  vec2 more = uintBitsToFloat(knots[3 * knot + 1]);
  return Knot(uintBitsToFloat(knots[3 * knot]), more.x, more.y);
}

// Returns a key below 2^16, nearest first: DistanceKeys of renderer/raster/raster_scene.h.
uint key_of(float inverse) {
  uint bits = floatBitsToUint(inverse);
  return 65535 - min((bits - min(key_furthest, bits)) >> key_shift, 65535);
}

// Returns 1 / distance of the segment's point that is nearest to the middle of a tile, but at least half a tile away from
// the segment's ends.
float inverse_near(Knot a, Knot b, vec2 middle) {
  vec2 segment = b.at - a.at;
  float squared = max(dot(segment, segment), 1e-6), along = dot(middle - a.at, segment) / squared;
  float end = min(0.5 * float(tile_side) / sqrt(squared), 0.5);
  return a.inverse + (b.inverse - a.inverse) * clamp(along, end, 1.0 - end);
}

// Returns whether a segment misses a tile although its bounding box overlaps it.
bool passes_by(Knot a, Knot b, vec2 middle, float wide) {
  const float corner = 0.71 * float(tile_side);  // distance of a tile's corner from its middle, pixels
  vec2 segment = b.at - a.at, off = middle - a.at;
  return abs(off.x * segment.y - off.y * segment.x) > (corner + wide) * length(segment);
}

void enter(uint tile, uint knot, float inverse) {
  uint number = atomicAdd(tile_counts[tile], 1);
  if (!writing) return;
  uint at = tile_entries[tile] + number;
  if (at < entry_capacity) entries[at] = uvec2(key_of(inverse), knot);
}

void enter_segment(uint knot) {
  Knot a = read_knot(knot), b = read_knot(knot + 1);
  if (!(a.inverse > 0.0 && b.inverse > 0.0)) return;
  float wide = max(max(a.half_width, b.half_width), 1.0) + 0.5;
  vec2 corner = vec2(box.xy), low = min(a.at, b.at) - wide - corner, high = max(a.at, b.at) + wide - corner;
  if (any(lessThanEqual(high, vec2(0.0))) || any(greaterThanEqual(low, vec2(box.zw) - corner))) return;
  ivec2 first = ivec2(clamp(low / float(tile_side), vec2(0.0), vec2(tiles - 1)));
  ivec2 last = ivec2(clamp(high / float(tile_side), vec2(0.0), vec2(tiles - 1)));
  float nearest = max(a.inverse, b.inverse);
  bool one = floor(low / float(tile_side)) == floor(high / float(tile_side));
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      uint tile = uint(y * tiles.x + x);
      if (!(nearest > furthest[tile])) continue;
      vec2 middle = corner + (vec2(x, y) + 0.5) * float(tile_side);
      if (!one && passes_by(a, b, middle, wide)) continue;
      enter(tile, knot, one ? 0.5 * (a.inverse + b.inverse) : inverse_near(a, b, middle));
    }
  }
}

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number(), first = first_knots[lane], end = first_knots[lane + 1];
  if (end > knot_capacity) return;
  for (uint knot = first; knot + 1 < end; ++knot) enter_segment(knot);
}
