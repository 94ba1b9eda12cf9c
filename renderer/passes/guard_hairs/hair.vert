#version 450 core
#include "frame.glsl"
#include "lean.glsl"
#include "strand.glsl"
#include "ribbon.glsl"
#include "paint_storage.glsl"

struct HairRoot {
  uvec3 corners;
  uint bits;
  vec3 weights;
};
layout(std430, binding = pass_storage) readonly buffer Hairs { HairRoot hairs[]; };

uniform int first;         // of the hairs to draw
uniform int segments;
uniform float limit;       // cosine to the camera from which on a hair fades in
uniform float width_root;  // sizes
uniform float width_tip;
uniform float bow;         // how far a hair may bow to a side, sizes
uniform float spread;      // of lightness, as the coat's colour_spread

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
out vec2 tile;            // of the root, in tiles
out float across;         // from the middle of the hair, pixels
flat out float lightness;
out float reach;          // half of the drawn width, pixels
out float strength;       // opacity in the middle

Strand mixed(HairRoot hair, float s, float stretch) {
  Strand a = strand_at(hair.corners.x, s, stretch), b = strand_at(hair.corners.y, s, stretch), c = strand_at(hair.corners.z, s, stretch);
  vec3 w = hair.weights;
  return Strand(w.x * a.root + w.y * b.root + w.z * c.root, w.x * a.place + w.y * b.place + w.z * c.place,
                w.x * a.normal + w.y * b.normal + w.z * c.normal, w.x * a.tangent + w.y * b.tangent + w.z * c.tangent,
                w.x * a.tile_uv + w.y * b.tile_uv + w.z * c.tile_uv,
                vec3(w.x * a.image_uv.xy + w.y * b.image_uv.xy + w.z * c.image_uv.xy, a.image_uv.z),
                w.x * a.colour + w.y * b.colour + w.z * c.colour,
                w.x * a.fur_length + w.y * b.fur_length + w.z * c.fur_length,
                w.x * a.varied + w.y * b.varied + w.z * c.varied);
}

float number_of(uint bits, int shift) { return float((bits >> shift) & 1023u) / 1023.0; }

// One hair for each instance: pairs of vertices from the root up, spread across the view.
void main() {
  HairRoot hair = hairs[first + gl_InstanceID];
  float s = float(gl_VertexID / 2) / float(segments), side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
  float longer = number_of(hair.bits, 0), stretch = mix(0.8, 1.25, longer * longer);  // few reach far out of the fur
  Strand strand = mixed(hair, s, stretch);
  vec3 normal = safe_unit(strand.normal);
  vec3 sideways = safe_unit(cross(normal, abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  float angle = 6.2831853 * number_of(hair.bits, 10);
  vec3 bends_to = sideways * cos(angle) + cross(normal, sideways) * sin(angle);
  float reached = bow * min(strand.fur_length / nominal_length, 1.0);
  place = strand.place + bends_to * (reached * s * s);
  fibre_normal = normal;
  fibre_tangent = strand.tangent + bends_to * (2.0 * reached * s / max(strand.fur_length * stretch, 1e-6));
  height = min(s * stretch, 1.0);
  length_share = strand.fur_length / nominal_length;
  base_uv = strand.image_uv;
  base_colour = strand.colour;
#ifdef PATTERN
  root = strand.root;
  varied = strand.varied;
#endif
  tile = strand.tile_uv * frame.tile.x;
  lightness = exp2(2.0 * spread * (2.0 * number_of(hair.bits, 20) - 1.0));

  float width = mix(width_root, width_tip, s);
  hand_on_paint(hair.corners, hair.weights);
#ifdef PAINT
  width *= amounts.y;
#endif
  Ribbon ribbon = ribbon_at(place, fibre_tangent, width, side);
  across = ribbon.across;
  reach = ribbon.reach;
  float facing = abs(dot(safe_unit(frame.viewpoint.xyz - strand.root), normal));
  strength = ribbon.strength * furred(strand.fur_length) * (1.0 - smoothstep(0.4 * limit, limit, facing)) *
             seen_through(height, facing, strand.fur_length);
#ifdef PAINT
  if (number_of(hair.bits * 2654435769u, 10) >= amounts.x && amounts.x < 1.0) strength = 0.0;  // one of those that are gone
#endif
  gl_Position = ribbon.clip;
}
