#version 450 core
// Finds the last kept strand of each part: Part::last.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "plan.glsl"
#include "pools.glsl"
#include "kept.glsl"
layout(local_size_x = 64) in;

void main() {
  if (group_number() * strand_group >= strand_count) return;
  KeptStrand kept = kept_strand(group_number(), gl_LocalInvocationIndex);
  if (kept.there) atomicMax(parts[kept.part].last, kept.strand + 1);
}
