#version 450 core
// Finds what each light crosses up to the far side of each cell: LightCells::sweep and follow_near, one work group for
// each light. The cells are done in waves, nearest to the light first; within a wave no cell reads another.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "cells.glsl"
const int lanes = 1024;
layout(local_size_x = lanes) in;
layout(std430, binding = within_storage) readonly buffer Within { uint within[]; };
layout(std430, binding = through_storage) coherent buffer Through { uint through[]; };  // all cells of a light, then those of the next

// Writes what the light crosses up to a cell's far side: its own crossing plus that of its neighbours on the light's side.
// `from`: for each axis, whether light enters from a neighbouring cell.
void follow(uint light, ivec3 cell, bvec3 from) {
  vec3 direction = to_light(light, cell), size = abs(direction);
  int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
  ivec3 step = ivec3(sign(direction));
  float longer = 1.0 / max(size[a], 0.5);
  float off_b = from[b] ? size[b] * longer : 0.0, off_c = from[c] ? size[c] * longer : 0.0;
  uint first = light * cell_count();
  Crossed own = crossed_of(within[first + cell_index(cell)]);
  Crossed sum = Crossed(longer * own.strands, longer * own.body);
  for (int k = 0; k < 4 && from[a] && step[a] != 0; ++k) {
    ivec3 off = ivec3(0);
    off[a] = step[a];
    if ((k & 1) != 0) off[b] = step[b];
    if ((k & 2) != 0) off[c] = step[c];
    float share = ((k & 1) != 0 ? off_b : 1.0 - off_b) * ((k & 2) != 0 ? off_c : 1.0 - off_c);
    if (share == 0.0 || !has_cell(cell + off)) continue;
    Crossed before = crossed_of(through[first + cell_index(cell + off)]);
    sum.strands += share * before.strands;
    sum.body += share * before.body;
  }
  through[first + cell_index(cell)] = crossed_word(sum);
}

void wait() {
  memoryBarrierBuffer();
  barrier();
}

// Sweeps slices across the main axis of the light's direction.
void follow_far(uint light) {
  vec3 direction = to_light(light, ivec3(0)), size = abs(direction);
  int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
  int cells = grid_size[b] * grid_size[c];
  for (int slice = 0; slice < grid_size[a]; ++slice) {
    for (int i = int(gl_LocalInvocationIndex); i < cells; i += lanes) {
      ivec3 cell;
      cell[a] = direction[a] > 0.0 ? grid_size[a] - 1 - slice : slice;
      cell[b] = i % grid_size[b];
      cell[c] = i / grid_size[b];
      follow(light, cell, bvec3(true));
    }
    wait();
  }
}

// Sweeps outwards from the cell that contains the light or is nearest to it, ordered by the number of steps to each
// cell.
void follow_near(uint light) {
  ivec3 first = ivec3(clamp(light_in_cells(light), vec3(0.0), vec3(grid_size - 1)));
  ivec3 furthest = max(first, grid_size - 1 - first);
  int rows = grid_size.y * grid_size.z;
  for (int wave = 0; wave <= furthest.x + furthest.y + furthest.z; ++wave) {
    for (int i = int(gl_LocalInvocationIndex); i < rows; i += lanes) {
      ivec3 cell = ivec3(0, i % grid_size.y, i / grid_size.y);
      int remaining = wave - abs(cell.y - first.y) - abs(cell.z - first.z);
      if (remaining < 0) continue;
      for (int side = -1; side <= (remaining == 0 ? -1 : 1); side += 2) {
        cell.x = first.x + side * remaining;
        if (has_cell(cell)) follow(light, cell, notEqual(cell, first));
      }
    }
    wait();
  }
}

void main() {
  uint light = gl_WorkGroupID.x;
  if (light >= light_count) return;
  if (is_far(light))
    follow_far(light);
  else
    follow_near(light);
}
