// The transmittance of fur and body, from the cells of a grid. The includer defines the grid: grid_low, grid_cell,
// grid_size, and crossed_cell, which reads a cell's values for a light.

// The eight cells around a position, with their trilinear weights.
struct GridCells {
  Real first;  // index of the lowest of the eight cells, an integer
  Real weight[8];
};

// The light that a fibre or the skin sends to the camera.
struct SentLight {
  Vec3 ambient, direct;
  Vec3 unshadowed;  // `direct` without shadows; only if requested
};

FUNCTION GridCells grid_cells(Vec3 position) {
  Vec3 off = (position - Vec3(grid_low)) * (1.0f / grid_cell) - Vec3(0.5f);
  Vec3 at = Vec3(clamp(off.x, 0.0f, float(grid_size.x) - 1.001f), clamp(off.y, 0.0f, float(grid_size.y) - 1.001f),
                 clamp(off.z, 0.0f, float(grid_size.z) - 1.001f));
  Vec3 low = floor(at), part = at - low;
  GridCells cells;
  cells.first = (low.z * float(grid_size.y) + low.y) * float(grid_size.x) + low.x;  // below 2^24
  for (int k = 0; k < 8; ++k) {
    cells.weight[k] = ((k & 1) != 0 ? part.x : 1.0f - part.x) * ((k & 2) != 0 ? part.y : 1.0f - part.y) *
                      ((k & 4) != 0 ? part.z : 1.0f - part.z);
  }
  return cells;
}

FUNCTION Crossing crossed_at(Index light, GridCells cells) {
  Real strands = Real(0.0f), body = Real(0.0f);
  for (int k = 0; k < 8; ++k) {
    int further = (k & 1) + ((k & 2) != 0 ? grid_size.x : 0) + ((k & 4) != 0 ? grid_size.x * grid_size.y : 0);
    Crossing cell = crossed_cell(light, cells.first, further);
    strands = mul_add(cells.weight[k], cell.strands, strands);
    body = mul_add(cells.weight[k], cell.body, body);
  }
  Crossing crossed;
  crossed.strands = strands * float(1.0f / crossed_one);
  crossed.body = body * float(1.0f / crossed_one);
  return crossed;
}

// Returns the cells at a distance from the skin, because a position's own cell also contains what lies below the skin.
FUNCTION GridCells cells_off_skin(Vec3 position, Vec3 normal) {
  float off_skin = 0.25f;  // cells
  return grid_cells(position + normal * (off_skin * grid_cell));
}

// Returns the transmittance of strands, each of which stops a share `stopped` of the light, and of the body.
FUNCTION Vec3 transmittance_of(Crossing crossed, Vec3 stopped) {
  return Vec3(exp2(-1.442695f * mul_add(crossed.strands, stopped.x, crossed.body)),
              exp2(-1.442695f * mul_add(crossed.strands, stopped.y, crossed.body)),
              exp2(-1.442695f * mul_add(crossed.strands, stopped.z, crossed.body)));
}
