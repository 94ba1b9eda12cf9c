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

// Returns the position of a knot among the points. It ends one beyond the tip: the tip of a taller strand gets more light
// than that of the lit strand.
float place_of(LightAlong light, int knot) {
  return clamp(light.first + float(knot) * light.step, 0.0, float(light.count));
}
// Returns the light of a point. The point after the tip holds how much more light the tip has than the point before it.
vec3 light_of(LightAlong light, int point) {
  if (point < light.count) return lit_points[light.points + uint(point)].rgb;
  uint tip = light.points + uint(light.count - 1);
  return lit_points[tip].rgb - lit_points[tip - 1u].rgb;
}
// Returns the weight of a point's light at a position at most one away from it; that of the tip stays 1 beyond it.
float share_of(LightAlong light, int point, float place) {
  float after = place - float(point);
  return after > 0.0 && point + 1 == light.count ? 1.0 : max(1.0 - abs(after), 0.0);
}
vec3 colour_of(Part part, uint strand, LightAlong light, int knot) {
  if (!is_coloured) return vec3(1.0);
  return (unpacked_colour(colour_word(part, strand, knot)) + over_black) * light.factor;
}

// The light at both ends of the segment between two drawn knots: PieceLight of renderer/raster/shared_light-inl.h.
struct PieceLight {
  float begin_place, end_place;
  vec3 begin_colour, end_colour;
  int low;               // the current point
  vec3 mean, next_mean;  // its mean weight, and that of the next point
  vec3 at_begin, at_end;
  vec3 all, wanted, tilt;  // sums: of mean weights; of how the begin's weight differs, before and after the clamp
};

// Adds the light of the point `low` to both ends, and goes on to the next point.
void next_point(inout PieceLight piece, LightAlong light) {
  vec3 wanted = 0.5 * (piece.begin_colour * share_of(light, piece.low, piece.begin_place) -
                     piece.end_colour * share_of(light, piece.low, piece.end_place));
  vec3 tilt = clamp(wanted, -piece.mean, piece.mean);
  vec3 sent = light_of(light, piece.low);
  piece.at_begin += (piece.mean + tilt) * sent;
  piece.at_end += (piece.mean - tilt) * sent;
  piece.all += piece.mean;
  piece.wanted += wanted;
  piece.tilt += tilt;
  piece.mean = piece.next_mean;
  piece.next_mean = vec3(0.0);
  ++piece.low;
}

// Makes light that is the same at all points also the same at both ends.
void even_out(inout PieceLight piece) {
  vec3 missing = piece.wanted - piece.tilt;  // at the begin, over all points
  vec3 from_end = clamp(missing / max(piece.all - piece.tilt, 1e-12), 0.0, 1.0) * piece.at_end;
  vec3 from_begin = clamp(-missing / max(piece.all + piece.tilt, 1e-12), 0.0, 1.0) * piece.at_begin;
  piece.at_begin += from_end - from_begin;
  piece.at_end -= from_end - from_begin;
}

void add(inout PieceLight piece, LightAlong light, float place, float share, vec3 colour) {
  while (place >= float(piece.low + 1) && piece.low + 1 < light.count) next_point(piece, light);
  piece.mean += colour * (share * share_of(light, piece.low, place));
  piece.next_mean += colour * (share * share_of(light, piece.low + 1, place));
}

PieceLight piece_light(Part part, uint strand, LightAlong light, int begin, int end) {
  PieceLight piece = PieceLight(place_of(light, begin), place_of(light, end), colour_of(part, strand, light, begin),
                                colour_of(part, strand, light, end), 0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0),
                                vec3(0.0), vec3(0.0));
  piece.low = min(int(piece.begin_place), light.count - 1);
  float share = 1.0 / float(end - begin);
  add(piece, light, piece.begin_place, 0.5 * share, piece.begin_colour);
  for (int k = begin + 1; k < end; ++k)
    add(piece, light, place_of(light, k), share, colour_of(part, strand, light, k));
  add(piece, light, piece.end_place, 0.5 * share, piece.end_colour);
  next_point(piece, light);
  bool ends_beyond = piece.low == light.count;
  if (!ends_beyond) next_point(piece, light);
  even_out(piece);
  if (ends_beyond) next_point(piece, light);  // the gain beyond the tip is not light that all points have
  return piece;
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
  if (end == first || end > knot_room) return;
  Part part = parts[groups[group_number()].x];
  uint strand = groups[group_number()].y + gl_LocalInvocationIndex, lit = lit_strand(part, strand, lit_strands(part));
  if (first_points[part.first + lit + 1] > lit_point_room) return;
  LightAlong light = light_along(part, strand, lit);
  int number = number_of(first, part.segments);
  vec3 before = vec3(0.0);
  for (uint k = first + 1u; k < end; ++k) {
    int next = number_of(k, part.segments);
    PieceLight piece = piece_light(part, strand, light, number, next);
    keep_light(k - 1u, k == first + 1u ? piece.at_begin : before, piece.at_begin);
    before = piece.at_end;
    number = next;
  }
  keep_light(end - 1u, before, before);
}
