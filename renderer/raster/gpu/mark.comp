#version 450 core
// Finds the strands whose light a drawn strand takes, and writes how many points of each are lit.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "plan.glsl"
#include "pools.glsl"
#include "lit_knots.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = strand_knots_storage) readonly buffer StrandKnots { uint first_knots[]; };
// Here the number of lit points of each strand; a scan turns them into first points.
layout(std430, binding = strand_points_storage) writeonly buffer StrandPoints { uint first_points[]; };

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number();
  if (first_knots[lane + 1] == first_knots[lane]) return;
  Part part = parts[groups[group_number()].x];
  uint lit = lit_strand(part, groups[group_number()].y + gl_LocalInvocationIndex, lit_strands(part));
  first_points[part.first + lit] = uint(lit_knots(part.segments, lit < lit_from_root(part)).count);
}
