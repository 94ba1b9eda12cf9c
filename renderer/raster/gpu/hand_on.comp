#version 450 core
// Derives the light of the drawn knots from the light at the points of the lit strand:
// renderer/raster/shared_light-inl.h.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "plan.glsl"
#include "pools.glsl"
#include "lit_knots.glsl"
#include "shown.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = strand_knots_storage) readonly buffer StrandKnots { uint first_knots[]; };
layout(std430, binding = strand_points_storage) readonly buffer StrandPoints { uint first_points[]; };
layout(std430, binding = lit_points_storage) readonly buffer LitPoints { vec4 lit_points[]; };
layout(std430, binding = knots_storage) buffer Knots { uvec2 knots[]; };

// Light along a strand: knots have the light of the same height.
struct LightAlong {
  uint points;  // the first of the lit strand
  int count;
  float first, step;  // of the points, at the first knot and from knot to knot
  vec3 factor;        // on colours
};

LightAlong light_along(Part part, uint strand, uint lit) {
  LitKnots points = lit_knots(part.segments, lit < lit_whole(part));
  float from = float(points.first) / float(part.segments);
  float over = float(points.count - 1) / max(1.0 - from, 1e-3);
  float taller = root_reach(part, strand) / max(root_reach(part, lit), 1e-3);
  vec3 factor = vec3(1.0);
  if (is_coloured && part.own_colour < 1.0 && part.has_mean)
    factor += (unpacked_colour(to_mean_word(part, strand)) + over_black - 1.0) * (1.0 - part.own_colour);
  return LightAlong(first_points[part.first + lit], points.count, -from * over, taller * over / float(part.segments),
                    factor);
}

vec3 light_at_knot(Part part, uint strand, LightAlong light, int knot) {
  float beyond_tip = 1.0;  // points; what is taller gets more light than the tip
  float place = clamp(light.first + float(knot) * light.step, 0.0, float(light.count - 1) + beyond_tip);
  int low = min(int(place), light.count - 2);
  vec3 a = lit_points[light.points + uint(low)].rgb, b = lit_points[light.points + uint(low) + 1].rgb;
  vec3 sent = a + (b - a) * (place - float(low));
  if (!is_coloured) return sent;
  return max(sent, 0.0) * (unpacked_colour(colour_word(part, strand, knot)) + over_black) * light.factor;
}

// Returns by how much the light of the knots between two drawn ones exceeds linear interpolation between these two, on
// average.
vec3 left_out(Part part, uint strand, LightAlong light, ivec2 ends, vec3 at_begin, vec3 at_end) {
  vec3 sum = vec3(0.0), straight = at_begin;
  float over = 1.0 / float(max(ends.y - ends.x, 1));
  vec3 rise = (at_end - at_begin) * over;
  for (int k = ends.x + 1; k < ends.y; ++k) {
    straight += rise;
    sum += light_at_knot(part, strand, light, k) - straight;
  }
  return sum * over;
}

int number_of(uint knot, int segments) {
  return int(unpackHalf2x16(knots[3 * knot + 2].y).y * float(segments) + 0.5);
}

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number(), first = first_knots[lane], end = first_knots[lane + 1];
  if (end == first || end > knot_room) return;
  Part part = parts[groups[group_number()].x];
  uint strand = groups[group_number()].y + gl_LocalInvocationIndex, lit = lit_strand(part, strand, lit_strands(part));
  if (first_points[part.first + lit + 1] > lit_point_room) return;
  LightAlong light = light_along(part, strand, lit);
  int number = number_of(first, part.segments);
  vec3 sent = light_at_knot(part, strand, light, number), more_before = vec3(0.0);
  for (uint k = first; k < end; ++k) {
    bool is_last = k + 1 == end;
    int next = is_last ? number : number_of(k + 1, part.segments);
    vec3 at_next = is_last ? sent : light_at_knot(part, strand, light, next);
    vec3 more_after = is_last ? more_before : left_out(part, strand, light, ivec2(number, next), sent, at_next);
    if (k == first) more_before = more_after;
    const float largest = 65504.0;  // of half floats
    vec3 shown = clamp((more_before + more_after) * 0.5 + sent, is_coloured ? 0.0 : -largest, largest);
    float along = unpackHalf2x16(knots[3 * k + 2].y).y;
    knots[3 * k + 2] = uvec2(packHalf2x16(shown.rg), packHalf2x16(vec2(shown.b, along)));
    number = next;
    sent = at_next;
    more_before = more_after;
  }
}
