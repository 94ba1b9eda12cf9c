#version 450 core
#include "frame.glsl"
#include "lean.glsl"
#include "strand.glsl"
#include "paint_storage.glsl"

struct FinEdge {
  uvec2 ends;
  float width;
  float padding;
};
layout(std430, binding = pass_storage) readonly buffer Fins { FinEdge fins[]; };

uniform int segments;
uniform float limit;       // cosine to the camera from which on a fin fades in
uniform float slab_depth;  // of the side view, sizes

out vec3 place;
out vec3 fibre_normal;
out vec3 fibre_tangent;
out vec3 base_uv;
out vec3 base_colour;
out float height;
out float length_share;
#ifdef PATTERN
out vec3 root;
out vec4 varied;
#endif
out float along;    // place on the side view, in its widths
out float strength; // factor on the optical depth

// One fin for each instance: pairs of vertices from the skin up.
void main() {
  FinEdge edge = fins[gl_InstanceID];
  height = float(gl_VertexID / 2) / float(segments);
  Strand strand = strand_at(gl_VertexID % 2 == 0 ? edge.ends.x : edge.ends.y, height, 1.0);
  place = strand.place;
  fibre_normal = strand.normal;
  length_share = strand.fur_length / nominal_length;
  fibre_tangent = strand.tangent;
  base_uv = strand.image_uv;
  base_colour = strand.colour;
#ifdef PATTERN
  root = strand.root;
  varied = strand.varied;
#endif
  // Along the axis of the tile that the edge follows more, so that strands go on from edge to edge.
  vec2 apart = abs(vertex_vec2(edge.ends.y, 9) - vertex_vec2(edge.ends.x, 9));
  along = (apart.x > apart.y ? strand.tile_uv.x : strand.tile_uv.y) * frame.tile.x;
  float facing = abs(dot(safe_unit(frame.viewpoint.xyz - strand.root), safe_unit(strand.normal)));
  strength = min(1.0, edge.width / slab_depth) * furred(strand.fur_length) * (1.0 - smoothstep(0.3 * limit, limit, facing));
  hand_on_paint(uvec3(gl_VertexID % 2 == 0 ? edge.ends.x : edge.ends.y), vec3(1.0, 0.0, 0.0));
#ifdef PAINT
  strength *= amounts.x * amounts.y;
#endif
  gl_Position = frame.world_to_clip * vec4(place, 1.0);
}
