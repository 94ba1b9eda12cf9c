#version 450 core
// Adds up how much of each cell's face strands cover: DensityGrid, a strand a lane. Sums are integers, so that they do not
// depend on the order of the strands.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "fur.glsl"
#include "cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = points_storage) readonly buffer Points { vec4 points[]; };
layout(std430, binding = cell_sums_storage) buffer CellSums { uint cell_sums[]; };

float exposed_share(FurStrand own) {
  float path = 0.0;
  uint last = own.first + uint(own.part.segments);
  for (uint k = own.first; k < last; ++k) path += length(points[k + 1].xyz - points[k].xyz);
  float reach = length(points[last].xyz - points[own.first].xyz);
  return 1.0 / (1.0 + curl_in_shadow * max(path / max(reach, 0.02 * path + 1e-9) - 1.0, 0.0));
}

// Adds a value to a 64-bit number that is stored with its low word first.
void add(uint at, float value) {
  const float low_end = 4294967296.0, largest = 1e10;
  float size = min(abs(value), largest) + 0.5;
  uint high = uint(size / low_end), low = uint(size - float(high) * low_end);
  if (value < 0.0) {
    low = ~low + 1;
    high = ~high + uint(low == 0);
  }
  if (low != 0) high += uint(atomicAdd(cell_sums[at], low) > ~low);  // the carry
  if (high != 0) atomicAdd(cell_sums[at + 1], high);
}

void add_segment(vec4 a, vec4 b, float share) {
  vec3 path = b.xyz - a.xyz;
  float size = length(path), over = 1.0 / grid_cell;
  int steps = clamp(int(min(ceil(size * over), 1e6)), 1, max_segment_steps);
  float part = 1.0 / float(steps);
  float width = share * density_one * (a.w + b.w) * over * over * part;
  for (int s = 0; s < steps; ++s) {
    vec3 at = a.xyz + path * ((float(s) + 0.5) * part);
    uint cell = sum_words * cell_index(clamp(ivec3((at - grid_low) * over), ivec3(0), grid_size - 1));
    add(cell, width * size);
    for (uint axis = 0; axis < 3; ++axis) add(cell + 2 * (axis + 1), width * path[axis]);
  }
}

void main() {
  FurStrand own = fur_strand();
  if (!own.there || own.strand >= own.part.summed) return;
  float share = own.part.each * exposed_share(own);
  for (uint k = own.first; k < own.first + uint(own.part.segments); ++k) add_segment(points[k], points[k + 1], share);
}
