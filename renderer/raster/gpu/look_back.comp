#version 450 core
// Finds what each light crosses up to the middle of each cell: LightCells::look_back, a cell a lane. Sums the cells along
// the ray itself near the cell, and adds what sweep.comp found from there on.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = within_storage) readonly buffer Within { uint within[]; };
layout(std430, binding = through_storage) readonly buffer Through { uint through[]; };
layout(std430, binding = crossed_storage) writeonly buffer CrossedCells { uint crossed_cells[]; };

// Rounds to 6 bits, but to steps of at least 1/64 strand: coarse of renderer/raster/cell_rows-inl.h.
float coarse(float number) {
  const float step = crossed_one / 64.0;
  if (number < crossed_one) return floor(number / step + 0.5) * step;
  return uintBitsToFloat(floatBitsToUint(number) + 0x10000u & ~0x1ffffu);
}

Crossed as_seen(Crossed sum) {
  if (sum.body > crossed_one * opaque_body_depth) return Crossed(float(max_crossed_strands), float(max_crossed_body));
  return Crossed(coarse(sum.strands), coarse(sum.body));
}

void add(inout Crossed sum, uint word, float share) {
  Crossed cell = crossed_of(word);
  sum.strands += share * cell.strands;
  sum.body += share * cell.body;
}

Crossed crossed_to(uint light, ivec3 cell) {
  uint first = light * cell_count();
  vec3 direction = to_light(light, cell);
  Crossed sum = Crossed(0.0, 0.0);
  for (int s = 0; s < light_near_steps; ++s) {
    ivec3 at = cell + ivec3(floor(0.5 + direction * float(s)));
    if (has_cell(at)) add(sum, within[first + cell_index(at)], s == 0 ? 0.5 : 1.0);
  }
  vec3 end = direction * float(light_near_steps), low = floor(end), part = end - low;
  for (int k = 0; k < 8; ++k) {
    ivec3 off = ivec3(k & 1, k >> 1 & 1, k >> 2), at = cell + ivec3(low) + off;
    vec3 share = mix(1.0 - part, part, vec3(off));
    if (has_cell(at)) add(sum, through[first + cell_index(at)], share.x * share.y * share.z);
  }
  return sum;
}

void main() {
  uint cell = lane_number();
  if (cell >= cell_count()) return;
  for (uint light = 0; light < light_count; ++light)
    crossed_cells[light * cell_count() + cell] = crossed_word(as_seen(crossed_to(light, cell_at(cell))));
}
