#version 450 core
// Fur from the camera inwards: its opacity, or one over its distance.
#include "frame.glsl"
#include "slab.glsl"
#include "covering.glsl"

in float density_share;
#ifdef TUFTS
in vec3 tile_u;
#endif

uniform int step_count;

layout(location = 0) out vec4 result;

void main() {
  look_around();
  if (!in_part()) discard;
#ifdef CROSSING
  keep_crossings();
#endif
#ifdef TUFTS
  shift_to_strand(normalize(fibre_normal), tile_u);
#endif
  float own = march(steps_in_slab(step_count), 0.0, density_share, shell_height(), shell_thickness()).opacity;
  if (own < min_opacity * shell_thickness()) discard;
  result = covering(own);
}
