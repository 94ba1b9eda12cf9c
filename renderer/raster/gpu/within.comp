#version 450 core
// Finds what each light crosses within each cell: LightCells::find_local, a cell a lane.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = cell_sums_storage) readonly buffer CellSums { uint cell_sums[]; };
layout(std430, binding = body_sums_storage) readonly buffer BodySums { uint body_sums[]; };
layout(std430, binding = within_storage) writeonly buffer Within { uint within[]; };  // all cells of a light, then those of the next

// Returns a signed 64-bit sum as a float.
float sum_of(uint at) {
  uint low = cell_sums[at], high = cell_sums[at + 1];
  bool negative = int(high) < 0;
  if (negative) {
    low = ~low + 1;
    high = ~high + uint(low == 0);
  }
  float size = float(high) * 4294967296.0 + float(low);
  return negative ? -size : size;
}

void main() {
  uint cell = lane_number();
  if (cell >= cell_count()) return;
  uint at = sum_words * cell;
  float total = sum_of(at);
  vec3 direction = vec3(sum_of(at + 2), sum_of(at + 4), sum_of(at + 6));
  for (uint light = 0; light < light_count; ++light) {
    Crossed crossed = Crossed(0.0, float(body_sums[light * cell_count() + cell]) / float(body_steps));
    if (total > 0.0) {
      float along = dot(direction, to_light(light, cell_at(cell))) / total;
      float across = sqrt(max(1.0 - (1.0 - strand_spread) * along * along, 0.0));
      crossed.strands = crossed_one / density_one * total * across;
    }
    within[light * cell_count() + cell] = crossed_word(crossed);
  }
}
