#version 450 core
// Finds the lowest and the highest point in each column of the grid: first of the fur, a column a lane, then also of the
// skin, a triangle a work group.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "cells.glsl"
#include "triangle_parts.glsl"
#include "columns.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = cell_sums_storage) readonly buffer CellSums { uint cell_sums[]; };
layout(std430, binding = columns_storage) buffer ColumnWords {
  uint top;  // highest point of all
  uint column_words[];  // lowest and highest point of each column
};
uniform bool of_skin;

void find_fur(uint column) {
  uint across = uint(grid_size.x);
  if (column >= across * uint(grid_size.z)) return;
  uint low = ~0u, high = 0;
  for (int y = 0; y < grid_size.y; ++y) {
    uint at = sum_words * cell_index(ivec3(column % across, y, column / across));
    if (cell_sums[at + 1] == 0 && float(cell_sums[at]) < solid_strands * density_one) continue;
    float bottom = grid_low.y + grid_cell * float(y);
    low = min(low, word_of(bottom));
    high = max(high, word_of(bottom + grid_cell));
  }
  column_words[2 * column] = low;
  column_words[2 * column + 1] = high;
  atomicMax(top, high);
}

void add_skin(uint triangle) {
  if (triangle >= triangle_count) return;
  TriangleParts parts =
      parts_of(corner_position(triangle, 0), corner_position(triangle, 1), corner_position(triangle, 2), 1.5 * grid_cell);
  for (uint part = gl_LocalInvocationIndex; part < parts.count; part += 64) {
    vec3 middle = middle_of(parts, part);
    uint column = 2 * column_of(middle), height = word_of(middle.y);
    atomicMin(column_words[column], height);
    atomicMax(column_words[column + 1], height);
    atomicMax(top, height);
  }
}

void main() {
  if (of_skin)
    add_skin(group_number());
  else
    find_fur(lane_number());
}
