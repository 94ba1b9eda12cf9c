#version 450 core
// The baseline of GPU fur (eq 1): light is computed at the vertices.
#include "frame.glsl"
#include "lighting.glsl"
#include "fur_vertex.glsl"

out vec3 vertex_light;   // for fur of colour 1

void main() {
  const float grey = 0.4;  // transmittance depends on the fur's colour, which is not known at vertices
  float s = place_vertex();
  int above = int(s * float(slice_count));
  float strands = frame.depth_above[above / 4][above % 4] * length_share;
  Fibre fibre = Fibre(world_position, shading_normal, normalize(fibre_tangent), normalize(frame.viewpoint.xyz - world_position),
                      vec3(grey), grey * colour_above(s), s, strands, 0.5, shine);
  vertex_light = fibre_light(fibre, vec4(world_position, 0.0)) / grey;
}
