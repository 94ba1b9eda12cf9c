// Light on strands, skin and ground: the code that is shared with the CPU, and the data that it reads.
const bool white_surroundings = false;
#include "../../shaders/shared/light.glsl"

layout(std430, binding = crossed_storage) readonly buffer CrossedCells { uint crossed_cells[]; };  // all cells of a light, then those of the next

Crossing crossed_cell(uint light, float first, int further) {
  uint cells = uint(grid_size.x * grid_size.y * grid_size.z);
  uint word = crossed_cells[light * cells + uint(first) + uint(further)];
  return Crossing(float(word & 0xffffu), float(word >> 16));
}

#include "../../shaders/shared/grid_shadow.glsl"
