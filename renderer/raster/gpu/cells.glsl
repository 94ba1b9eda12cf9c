// The cells of the shadow grid: renderer/raster/light_cells.h.
const uint sum_words = 8;         // of a cell: coverage of its face by strands, and that times their direction (x, y, z); 64 bits each
const uint body_steps = 16;       // sums of skin are in steps of 1 / (body_steps crossed_one)

uint cell_count() { return uint(grid_size.x * grid_size.y * grid_size.z); }
uint cell_index(ivec3 cell) { return uint((cell.z * grid_size.y + cell.y) * grid_size.x + cell.x); }
ivec3 cell_at(uint index) {
  int at = int(index);
  return ivec3(at % grid_size.x, at / grid_size.x % grid_size.y, at / (grid_size.x * grid_size.y));
}
bool has_cell(ivec3 cell) { return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, grid_size)); }

// What a light crosses within a cell or on its way to it, in steps of 1 / crossed_one.
struct Crossed {
  float strands, body;
};
Crossed crossed_of(uint word) { return Crossed(float(word & 0xffffu), float(word >> 16)); }
uint crossed_word(Crossed sum) {
  uint strands = uint(min(sum.strands + 0.5, float(max_crossed_strands))), body = uint(min(sum.body + 0.5, float(max_crossed_body)));
  return strands | body << 16;
}

bool is_far(uint light) { return frame.lights[light].direction.w < 0.5; }
// Returns the position of a light, in cells.
vec3 light_in_cells(uint light) { return (frame.lights[light].position.xyz - grid_low) / grid_cell; }
vec3 to_light(uint light, ivec3 cell) {
  if (is_far(light)) return -frame.lights[light].direction.xyz;
  vec3 apart = light_in_cells(light) - (vec3(cell) + 0.5);
  return apart / max(length(apart), 1e-3);
}
