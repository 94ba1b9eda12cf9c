#version 450 core
// Fur from the eye inwards: its opacity, or one over its distance.
#include "frame.glsl"
#include "slab.glsl"
#include "covering.glsl"

in float density_share;
#ifdef TUFTS
in vec3 fibre_normal;
in vec3 tile_u;
#endif

uniform int step_count;  // texture steps inside the slab

layout(location = 0) out vec4 result;

void main() {
#ifdef CROSSING
  keep_crossings();
#endif
#ifdef TUFTS
  shift_to_strand(normalize(fibre_normal), tile_u);
#endif
  float own = march(step_count, 0.0, density_share).opacity;
  if (own * float(shell_count) < 0.02) discard;  // as fur.frag does
  result = covering(own);
}
