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
  float own = march(step_count, 0.0, density_share, shell_height(), 1.0 / float(shell_count)).opacity;
  if (own * float(shell_count) < 0.002) discard;  // as fur.frag does
  result = covering(own);
}
