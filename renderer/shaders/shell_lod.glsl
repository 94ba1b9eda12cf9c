// Non-uniform shells (renderer/upload/shell_lod.h). Returns the height at which the slab of a shell begins, in shells
// from the skin.
float slab_begin(int index, float lod) {
  float height = float(index);
  for (int halving = 0; halving < max_shell_lod; ++halving) {
    int step = 1 << halving;
    if ((index & step) == 0) continue;
    height += float(step) * clamp(lod - float(halving), 0.0, 1.0);
    index += step;
  }
  return min(height, float(shell_count));
}
