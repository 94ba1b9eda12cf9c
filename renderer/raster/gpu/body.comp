#version 450 core
// Adds up how much of each cell's face the skin covers: skin_facing_away of renderer/raster/light_cells.cpp, a triangle a
// work group.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "scene.glsl"
#include "cells.glsl"
#include "triangle_parts.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = corners_storage) readonly buffer Corners { float corners[]; };
layout(std430, binding = body_sums_storage) buffer BodySums { uint body_sums[]; };  // all cells of a light, then those of the next

const uint corner_weight = 14;  // index of `weight` in a FurCorner
const uint enough = 1u << 31;   // a sum that stops all light: adding ends there, so that sums do not overflow

float facing_away(vec3 a, vec3 b, vec3 c, uint light) {
  vec3 apart = (a + b + c) / 3.0 - frame.lights[light].position.xyz;
  vec3 from = is_far(light) ? frame.lights[light].direction.xyz : apart / max(length(apart), 1e-6);
  return 0.5 * dot(cross(b - a, c - a), from);
}

void main() {
  uint triangle = group_number();
  if (triangle >= triangle_count) return;
  vec3 a = corner_position(triangle, 0), b = corner_position(triangle, 1), c = corner_position(triangle, 2);
  float weight = corners[3 * triangle * corner_words + corner_weight];
  TriangleParts parts = parts_of(a, b, c, 0.75 * grid_cell);
  for (uint light = 0; light < light_count; ++light) {
    float away = facing_away(a, b, c, light) * weight;
    if (!(away > 0.0)) continue;
    float covered = away / float(parts.count) / (grid_cell * grid_cell);
    uint added = uint(min(covered * skin_depth * crossed_one * float(body_steps), 65536.0) + 0.5);
    for (uint part = gl_LocalInvocationIndex; part < parts.count; part += 64) {
      ivec3 cell = ivec3(floor((middle_of(parts, part) - grid_low) / grid_cell));
      if (!has_cell(cell)) continue;
      uint at = light * cell_count() + cell_index(cell);
      if (body_sums[at] < enough) atomicAdd(body_sums[at], added);
    }
  }
}
