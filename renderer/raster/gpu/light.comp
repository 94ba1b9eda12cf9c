#version 450 core
// Lights the points of strands: renderer/raster/strand_light-inl.h, a strand a lane.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "fibre_scattering.glsl"
#include "scene.glsl"
#include "plan.glsl"
#include "pools.glsl"
#include "strand.glsl"
#include "lit_knots.glsl"
#include "shown.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = strand_points_storage) readonly buffer StrandPoints { uint first_points[]; };
layout(std430, binding = lit_points_storage) writeonly buffer LitPoints { vec4 lit_points[]; };

#ifdef SHOWN_FIELD
#include "field.glsl"

// Returns the field at a strand's root; 0 if the strand stands on no triangle.
vec3 field_at_root(uint root) {
  uint triangle = pool_words[root + 7], shares = pool_words[root + 8];
  if (triangle == 0xffffffffu) return vec3(0.0);
  return field_at(triangle, float(shares & 0xffffu) / 65535.0, float(shares >> 16) / 65535.0);
}
#else
#include "lights.glsl"
#include "near_cells.glsl"
layout(std430, binding = near_storage) readonly buffer NearCells {
  uint near_total[2];  // sum of all cells, low word first
  uint near_cells[];   // two cells in a word
};
float near_mean;
float near_count(vec3 cell) {
  uint index = near_index(cell);
  return float(near_cells[index / 2] >> (index % 2 * 16) & 0xffffu);
}
#include "../../shaders/shared/strand_light.glsl"

Shine painted_shine(float painted) {
  float wetter = min(wetness + painted, 1.0);
  return Shine((1.0 + water_shines * wetter) / (1.0 + water_shines * wetness),
               (1.0 + water_sharpens * wetter) / (1.0 + water_sharpens * wetness));
}

// Returns 1 for a coat no higher than a cell, falling to 0 at two and a half cells.
float thinness(StrandDepth depth) {
  float height = dot(depth.tip - depth.root, depth.normal) / max(depth.reach, 0.01);
  return 1.0 - smoothstep(1.0 * grid_cell, 2.5 * grid_cell, height);
}

// What all points of a strand share.
struct LitStrand {
  StrandDepth depth;
  vec3 ambient;
  float number, thin;
  Shine shine;
};

vec3 knot_position(Part part, uint strand, int knot) { return point_of(part, strand, knot).xyz; }

LitStrand lit_strand_of(Part part, uint strand, LitKnots lit) {
  vec3 root = knot_position(part, strand, 0), before = root;
  float arc_length = 0.0;
  for (int p = 0; p < lit.count; ++p) {
    vec3 position = knot_position(part, strand, lit_knot(lit, part.segments, p));
    arc_length += length(position - before);
    before = position;
  }
  LitStrand of;
  of.depth = strand_depth(part, strand, root, before, arc_length);
  uint at = root_at(part, strand);
  of.number = root_number(at, 3);
  of.shine = painted_shine(root_number(at, 6));
  of.thin = part.is_curve ? 0.0 : thinness(of.depth);
  of.ambient = frame.weights.x * environment_light(of.depth.normal);
  return of;
}

Fibre fibre_at(Part part, uint strand, LitStrand of, int knot, vec3 colour) {
  Fibre fibre;
  fibre.position = knot_position(part, strand, knot);
  fibre.normal = of.depth.normal;
  fibre.tangent =
      unit(knot_position(part, strand, min(knot + 1, part.segments)) - knot_position(part, strand, max(knot - 1, 0)));
  fibre.to_camera = unit(camera_position - fibre.position);
  fibre.colour = clamp(colour, 0.0, 1.0);
  fibre.height = of.depth.reach * (float(knot) / float(part.segments));
  fibre.number = of.number;
  fibre.shine = of.shine;
  fibre.above = depth_above(fibre.height) * of.depth.over * part.crowding;
  fibre.crossed = fibre.colour * frame.colour_above[slice_at(fibre.height)].rgb;
  return fibre;
}

vec3 output_value(Fibre fibre, LitStrand of) {
#if defined SHOWN_ALBEDO
  return fibre.colour;
#elif defined SHOWN_NORMAL
  return fibre.normal;
#elif defined SHOWN_TANGENT
  return fibre.tangent;
#elif defined SHOWN_DIRECT
  return strand_light(fibre, of.thin, of.ambient, false).direct;
#elif defined SHOWN_SHADOW
  SentLight sent = strand_light(fibre, of.thin, of.ambient, true);
  return vec3(luminance(sent.direct), luminance(sent.unshadowed), 0.0);
#else
  SentLight sent = strand_light(fibre, of.thin, of.ambient, false);
  return sent.ambient + sent.direct;
#endif
}
#endif

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number(), first = first_points[lane], end = first_points[lane + 1];
  if (end == first || end > lit_point_capacity) return;
  Part part = parts[groups[group_number()].x];
  uint strand = groups[group_number()].y + gl_LocalInvocationIndex;
  LitKnots lit = lit_knots(part.segments, strand < lit_from_root(part));
#ifdef SHOWN_FIELD
  vec3 field = field_at_root(root_at(part, strand));
  for (int p = 0; p < lit.count; ++p) lit_points[first + uint(p)] = vec4(field, 0.0);
#else
  near_mean = (float(near_total[1]) * 4294967296.0 + float(near_total[0])) / float(near_entries);
  LitStrand of = lit_strand_of(part, strand, lit);
  for (int p = 0; p < lit.count; ++p) {
    int knot = lit_knot(lit, part.segments, p);
    vec3 colour = unpacked_colour(colour_word(part, strand, knot));
    vec3 sent = output_value(fibre_at(part, strand, of, knot, colour), of);
    if (is_coloured) sent /= colour + black_offset;
    lit_points[first + uint(p)] = vec4(sent, 0.0);
  }
#endif
}
