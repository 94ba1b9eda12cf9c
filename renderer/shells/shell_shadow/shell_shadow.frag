#version 450 core
#include "frame.glsl"
#include "slab.glsl"


in float density_share;
#ifdef TUFTS
in vec3 tile_u;
#endif

const int steps = 2;  // texture samples inside each shell's slab

layout(location = 0) out float transmitted;

// The transmittance of one shell along the ray from the light; blending multiplies those of all shells.
void main() {
  compute_derivatives();
  if (dot(fibre_normal, frame.viewpoint.xyz - world_position) <= 0.0) discard;
#ifdef TUFTS
  shift_to_strand(normalize(fibre_normal), tile_u);
#endif
  transmitted = 1.0 - march(steps, 0.0, density_share, shell_height(), shell_thickness()).opacity;
}
