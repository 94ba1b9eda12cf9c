#version 450 core
// Replaces the segment that covers most of a pixel by its strand, for RasterOutput::strand: the strand's number from 1,
// the position along it, and its coat. Pixels where skin or an eye covers more get 0.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "plan.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = sums_storage) buffer Sums { vec4 sums[]; };  // knot | knot_bit, position along the segment, coverage
layout(std430, binding = 1) readonly buffer Ends { float ends[]; };
layout(std430, binding = strand_knots_storage) readonly buffer StrandKnots { uint first_knots[]; };
layout(std430, binding = knots_storage) readonly buffer Knots { uvec2 knots[]; };

// Returns the lane of the strand to which a knot belongs.
uint lane_of(uint knot) {
  uint low = 0, length = strand_count;
  for (int bits = 0; bits < 32 && length > 0; ++bits) {
    uint middle = low + length / 2;
    bool is_before = first_knots[middle + 1] <= knot;
    low = is_before ? middle + 1 : low;
    length = is_before ? length - length / 2 - 1 : length / 2;
  }
  return low;
}

float along_of(uint knot) { return unpackHalf2x16(knots[3 * knot + 2].y).y; }

vec3 named(vec4 sum, float behind) {
  uint bits = floatBitsToUint(sum.x), knot = bits & ~knot_bit;
  if ((bits & knot_bit) == 0 || (behind > 0.0 && sum.a > sum.z)) return vec3(0.0);
  uint lane = lane_of(knot);
  Part part = parts[groups[lane / strand_group].x];
  float number = float(part.number + groups[lane / strand_group].y + lane % strand_group + 1);
  return vec3(number, mix(along_of(knot), along_of(knot + 1), sum.y), part.coat);
}

void main() {
  uint at = (gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x) * tile_pixels + gl_LocalInvocationIndex;
  vec4 sum = sums[at];
  sums[at] = vec4(named(sum, ends[at]), sum.a);
}
