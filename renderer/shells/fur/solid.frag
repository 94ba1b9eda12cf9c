#version 450 core
#include "frame.glsl"
#include "slab.glsl"

// Writes depth only, where the fur is dense. Uses coarser mip levels, so that gaps between strands leave no holes. Each
// patch counts fully where patches overlap; otherwise their overlap would have holes.
void main() {
  compute_derivatives();
  if (march(1, 2.0, 1.0, shell_height(), shell_thickness()).opacity < 0.93) discard;
}
