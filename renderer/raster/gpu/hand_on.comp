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

// Light along a strand, interpolated between the points of its lit strand; a knot takes the light at its own height.
struct LightAlong {
  uint points;  // index of the lit strand's first point
  int count;    // number of its points
  float first, step;  // position among the points of the first knot, and from knot to knot
  vec3 factor;        // on the colours of the knots
};

LightAlong light_along(Part part, uint strand, uint lit) {
  LitKnots points = lit_knots(part.segments, lit < lit_from_root(part));
  float from = float(points.first) / float(part.segments);
  float over = float(points.count - 1) / max(1.0 - from, 1e-3);
  float taller = root_reach(part, strand) / max(root_reach(part, lit), 1e-3);
  vec3 factor = vec3(1.0);
  if (is_coloured && part.own_colour < 1.0 && part.has_mean)
    factor += (unpacked_colour(to_mean_word(part, strand)) + black_offset - 1.0) * (1.0 - part.own_colour);
  return LightAlong(first_points[part.first + lit], points.count, -from * over, taller * over / float(part.segments),
                    factor);
}

// Returns the position of a knot among the points. It ends one beyond the tip: the tip of a taller strand gets more light
// than that of the lit strand.
float point_coordinate(LightAlong light, int knot) {
  return clamp(light.first + float(knot) * light.step, 0.0, float(light.count));
}
// Returns the light of a point. The point after the tip holds how much more light the tip has than the point before it.
vec3 light_of(LightAlong light, int point) {
  if (point < light.count) return lit_points[light.points + uint(point)].rgb;
  uint tip = light.points + uint(light.count - 1);
  return lit_points[tip].rgb - lit_points[tip - 1u].rgb;
}
// Returns the weight of a point's light at a position at most one away from it; that of the tip stays 1 beyond it.
float share_of(LightAlong light, int point, float coordinate) {
  float after = coordinate - float(point);
  return after > 0.0 && point + 1 == light.count ? 1.0 : max(1.0 - abs(after), 0.0);
}
vec3 colour_of(Part part, uint strand, LightAlong light, int knot) {
  if (!is_coloured) return vec3(1.0);
  return (unpacked_colour(colour_word(part, strand, knot)) + black_offset) * light.factor;
}

// The light at both ends of the segment between two drawn knots: SegmentLight of renderer/raster/shared_light-inl.h.
struct SegmentLight {
  float begin_coordinate, end_coordinate;
  vec3 begin_colour, end_colour;
  int low;               // the current point
  vec3 mean, next_mean;  // its mean weight, and that of the next point
  vec3 at_begin, at_end;
  vec3 all, wanted, tilt;  // sums: of mean weights; of how the begin's weight differs, before and after the clamp
};

// Adds the light of the point `low` to both ends, and goes on to the next point.
void next_point(inout SegmentLight segment, LightAlong light) {
  vec3 wanted = 0.5 * (segment.begin_colour * share_of(light, segment.low, segment.begin_coordinate) -
                     segment.end_colour * share_of(light, segment.low, segment.end_coordinate));
  vec3 tilt = clamp(wanted, -segment.mean, segment.mean);
  vec3 sent = light_of(light, segment.low);
  segment.at_begin += (segment.mean + tilt) * sent;
  segment.at_end += (segment.mean - tilt) * sent;
  segment.all += segment.mean;
  segment.wanted += wanted;
  segment.tilt += tilt;
  segment.mean = segment.next_mean;
  segment.next_mean = vec3(0.0);
  ++segment.low;
}

// Makes light that is the same at all points also the same at both ends.
void even_out(inout SegmentLight segment) {
  vec3 missing = segment.wanted - segment.tilt;  // at the begin, over all points
  vec3 from_end = clamp(missing / max(segment.all - segment.tilt, 1e-12), 0.0, 1.0) * segment.at_end;
  vec3 from_begin = clamp(-missing / max(segment.all + segment.tilt, 1e-12), 0.0, 1.0) * segment.at_begin;
  segment.at_begin += from_end - from_begin;
  segment.at_end -= from_end - from_begin;
}

void add(inout SegmentLight segment, LightAlong light, float coordinate, float share, vec3 colour) {
  while (coordinate >= float(segment.low + 1) && segment.low + 1 < light.count) next_point(segment, light);
  segment.mean += colour * (share * share_of(light, segment.low, coordinate));
  segment.next_mean += colour * (share * share_of(light, segment.low + 1, coordinate));
}

SegmentLight segment_light(Part part, uint strand, LightAlong light, int begin, int end) {
  SegmentLight segment = SegmentLight(point_coordinate(light, begin), point_coordinate(light, end), colour_of(part, strand, light, begin),
                                colour_of(part, strand, light, end), 0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0),
                                vec3(0.0), vec3(0.0));
  segment.low = min(int(segment.begin_coordinate), light.count - 1);
  float share = 1.0 / float(end - begin);
  add(segment, light, segment.begin_coordinate, 0.5 * share, segment.begin_colour);
  for (int k = begin + 1; k < end; ++k)
    add(segment, light, point_coordinate(light, k), share, colour_of(part, strand, light, k));
  add(segment, light, segment.end_coordinate, 0.5 * share, segment.end_colour);
  next_point(segment, light);
  bool ends_beyond = segment.low == light.count;
  if (!ends_beyond) next_point(segment, light);
  even_out(segment);
  if (ends_beyond) next_point(segment, light);  // the gain beyond the tip is not light that all points have
  return segment;
}

int number_of(uint knot, int segments) {
  return int(unpackHalf2x16(knots[3 * knot + 2].y).y * float(segments) + 0.5);
}

void keep_light(uint knot, vec3 before, vec3 after) {
  const float largest = 65504.0;  // largest half float
  vec3 kept = clamp(0.5 * (before + after), is_coloured ? 0.0 : -largest, largest);
  float along = unpackHalf2x16(knots[3 * knot + 2].y).y;
  knots[3 * knot + 2] = uvec2(packHalf2x16(kept.rg), packHalf2x16(vec2(kept.b, along)));
}

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number(), first = first_knots[lane], end = first_knots[lane + 1];
  if (end == first || end > knot_capacity) return;
  Part part = parts[groups[group_number()].x];
  uint strand = groups[group_number()].y + gl_LocalInvocationIndex, lit = lit_strand(part, strand, lit_strands(part));
  if (first_points[part.first + lit + 1] > lit_point_capacity) return;
  LightAlong light = light_along(part, strand, lit);
  int number = number_of(first, part.segments);
  vec3 before = vec3(0.0);
  for (uint k = first + 1u; k < end; ++k) {
    int next = number_of(k, part.segments);
    SegmentLight segment = segment_light(part, strand, light, number, next);
    keep_light(k - 1u, k == first + 1u ? segment.at_begin : before, segment.at_begin);
    before = segment.at_end;
    number = next;
  }
  keep_light(end - 1u, before, before);
}
