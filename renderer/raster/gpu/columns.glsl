// The lowest and the highest point of fur and skin in each column of the grid: Columns of
// renderer/raster/sky_over_ground.cpp. Heights are stored as unsigned words that sort in the same order.
uint word_of(float height) {
  uint bits = floatBitsToUint(height);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}
float height_of(uint word) { return uintBitsToFloat((word & 0x80000000u) != 0 ? word & 0x7fffffffu : ~word); }

// Returns the index of a column, in rows by z. Positions outside the grid belong to the columns at its edge.
uint column_of(vec3 position) {
  vec3 cell = clamp((position - grid_low) / grid_cell, vec3(0.0), vec3(grid_size) - 0.5);
  return uint(cell.z) * uint(grid_size.x) + uint(cell.x);
}
