#version 450 core
// Adds the strands of the parts near the camera to the near cells: renderer/raster/near_cells.cpp, a strand a lane.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "fur.glsl"
#include "near_cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = points_storage) readonly buffer Points { vec4 points[]; };
layout(std430, binding = near_storage) buffer NearCells {
  uint near_total[2];  // sum of all cells, low word first
  uint near_cells[];   // two cells in a word
};

shared uint sum_of_group;

uint add_segment(vec4 a, vec4 b) {
  float over = 1.0 / near_cell;
  vec3 segment = b.xyz - a.xyz;
  float size = length(segment);
  float steps = clamp(ceil(size * over), 1.0, 1024.0), part = 1.0 / steps;
  uint added = uint(clamp(near_one * (a.w + b.w) * size * over * over * part, 0.0, max_near_step) + 0.5);
  if (added == 0) return 0;
  for (float s = 0.5; s < steps; ++s) {
    uint cell = near_index(floor(clamp((a.xyz + segment * (s * part)) * over, -1e9, 1e9)));
    atomicAdd(near_cells[cell / 2], added << (cell % 2 * 16));
  }
  return added * uint(steps);
}

void main() {
  if (gl_LocalInvocationIndex == 0) sum_of_group = 0;
  barrier();
  FurStrand own = fur_strand();
  if (own.there && own.part.near) {
    uint sum = 0;
    for (uint k = own.first; k < own.first + uint(own.part.segments); ++k) sum += add_segment(points[k], points[k + 1]);
    atomicAdd(sum_of_group, sum);
  }
  barrier();
  if (gl_LocalInvocationIndex != 0 || sum_of_group == 0) return;
  if (atomicAdd(near_total[0], sum_of_group) > ~sum_of_group) atomicAdd(near_total[1], 1);
}
