// The index of a near cell by the hash of its coordinates: renderer/raster/near_cells.cpp.
uint near_index(vec3 cell) {
  uvec3 part = uvec3(ivec3(cell)) * uvec3(near_of_x, near_of_y, near_of_z);
  return (part.x ^ part.y ^ part.z) & uint(near_entries - 1);
}
