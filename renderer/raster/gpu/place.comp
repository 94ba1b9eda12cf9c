#version 450 core
// Places strands on the picture: renderer/raster/place-inl.h, a strand a lane. The first pass counts the knots that each
// is drawn with, the second writes them.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "../../shaders/dialect.glsl"
#include "../../shaders/shared/strand.glsl"
#include "scene.glsl"
#include "plan.glsl"
#include "pools.glsl"
#include "kept.glsl"
#include "strand.glsl"
layout(local_size_x = 64) in;

layout(std430, binding = hidden_storage) readonly buffer Hidden { float hidden[]; };  // for each block of pixels: SkinPixels::hidden
// For each lane: the number of its knots in the first pass, its first knot in the second.
layout(std430, binding = strand_knots_storage) buffer StrandKnots { uint first_knots[]; };
// Three for each knot: position; 1 / distance, half width; light (rgb) and position along the strand as half floats.
layout(std430, binding = knots_storage) buffer Knots { uvec2 knots[]; };
uniform bool writing;

// Returns whether a strand touches the box and may be visible in it: seen_lanes of renderer/raster/place-inl.h.
bool is_seen(Part part, KeptStrand kept, PlacedStrand placed, float wider) {
  float beside = drawn_margin + (wider - 1.0) * placed.widest;
  if (any(lessThanEqual(placed.high, vec2(box.xy) - beside)) || any(greaterThanEqual(placed.low, vec2(box.zw) + beside)))
    return false;
  if (2.0 * placed.longest + wider * placed.widest > hiding_radius - drawn_margin) return true;
  int across = tiles.x * int(tile_side) / hiding_side;
  for (int k = part.segments; k >= 0; --k) {
    Knot knot = knot_of(part, kept.strand, k, kept.widened);
    if (any(lessThan(knot.at, vec2(box.xy))) || any(greaterThanEqual(knot.at, vec2(box.zw)))) return true;
    ivec2 block = ivec2(knot.at - vec2(box.xy)) / hiding_side;
    if (knot.inverse > hidden[block.y * across + block.x]) return true;
  }
  return false;
}

// How a strand is drawn.
struct DrawnStrand {
  int first, deep;  // first knot drawn; knots before `deep` are visible only through gaps between strands
  int count;        // number of segments that are drawn
  float packing;    // of KeptLane in renderer/raster/place-inl.h
};

DrawnStrand drawn_strand(Part part, KeptStrand kept, PlacedStrand placed, bool from_root) {
  StrandDepth depth = strand_depth(part, kept.strand, placed.root, placed.tip, placed.size);
  DrawnStrand drawn;
  drawn.deep = hidden_knot(part, depth);
  drawn.first = from_root ? 0 : drawn.deep;
  int remaining = part.segments - drawn.first;
  float wanted = placed.arc_length / min_segment * float(remaining) / float(part.segments);
  drawn.count = min(remaining, max(2, int(min(wanted, 64.0))));
  float more = kept.widened * camera_scale;
  drawn.packing = packing_of(part, depth) / (more * more);
  return drawn;
}

int knot_number(DrawnStrand drawn, int segments, int at) {
  float step = float(segments - drawn.first) / float(drawn.count);
  return drawn.first + int(float(at) * step + 0.01);
}

// Returns a knot as it is drawn, widened for packing (packed_half of renderer/raster/place-inl.h). Deep knots are wider,
// but not so wide that they would be visible beside the fur above them.
Knot drawn_knot(Part part, KeptStrand kept, PlacedStrand placed, DrawnStrand drawn, int number) {
  Knot knot = knot_of(part, kept.strand, number, kept.widened);
  float thin = knot.half_width, over = thin / max(knot.inverse, 1e-9), unresolved = clamp(1.5 - thin, 0.0, 1.0);
  float crowded = thin / (1.0 - unresolved * min(max_packed, drawn.packing * over * over));
  float above = placed.reach * (1.0 - float(number) / float(part.segments));
  knot.half_width = number < drawn.deep ? clamp(0.5 * above, crowded, max(crowded, float(deep_strand_factor) * thin)) : crowded;
  return knot;
}

// Extends the tip: a strand ends in a half ball, which covers as much as a longer strand with a flat end would.
vec2 rounded_tip(Knot tip, Knot before, float wider) {
  float more = 0.785 * tip.half_width / (wider * max(length(tip.at - before.at), 1e-3));
  return tip.at + more * (tip.at - before.at);
}

// Returns the half width of a knot, wider if the turns of a curl are too small to be drawn, so that the coverage stays the
// same. `more`: length of the curl over what is drawn of it.
float wider_for_curls(float half_width, float more, float step) {
  return more < 1.1 ? half_width : min(half_width * more, half_width + min(step, 1.0));
}

void write_strand(Part part, KeptStrand kept, PlacedStrand placed, DrawnStrand drawn, uint first) {
  Knot knot = drawn_knot(part, kept, placed, drawn, drawn.first), before;
  vec2 tip;
  float arc_length = 0.0;
  for (int i = 1; i <= drawn.count; ++i) {
    before = knot;
    knot = drawn_knot(part, kept, placed, drawn, knot_number(drawn, part.segments, i));
    tip = i == drawn.count ? rounded_tip(knot, before, part.wider * kept.widened) : knot.at;
    arc_length += length(tip - before.at);
  }
  int remaining = part.segments - drawn.first;
  float over = 1.0 / float(part.segments);
  float more = drawn.count < remaining ? placed.arc_length * float(remaining) * over / max(arc_length, 1e-3) : 1.0;
  for (int i = 0; i <= drawn.count; ++i) {
    int number = knot_number(drawn, part.segments, i);
    knot = drawn_knot(part, kept, placed, drawn, number);
    if (i == drawn.count) knot.at = tip;
    knot.half_width = wider_for_curls(knot.half_width, more, placed.arc_length * over);
    uint at = 3 * (first + uint(i));
    knots[at] = floatBitsToUint(knot.at);
    knots[at + 1] = floatBitsToUint(vec2(knot.inverse, knot.half_width));
    knots[at + 2] = uvec2(0, packHalf2x16(vec2(0.0, float(number) * over)));
  }
}

void main() {
  if (group_number() * strand_group >= strand_count) return;
  uint lane = lane_number();
  KeptStrand kept = kept_strand(group_number(), gl_LocalInvocationIndex);
  uint count = 0;
  if (writing) {
    uint end = first_knots[lane + 1];
    if (end == first_knots[lane] || end > knot_capacity) return;
  } else if (!kept.there) {
    first_knots[lane] = 0;
    return;
  }
  Part part = parts[kept.part];
  bool from_root = kept.strand < strands_from_root(part);
  PlacedStrand placed = place_strand(part, kept.strand, kept.widened);
  if (!writing && !is_seen(part, kept, placed, from_root ? float(deep_strand_factor) : 1.0)) {
    first_knots[lane] = 0;
    return;
  }
  DrawnStrand drawn = drawn_strand(part, kept, placed, from_root);
  if (!writing) {
    first_knots[lane] = uint(drawn.count) + 1;
    return;
  }
  drawn.count = int(first_knots[lane + 1] - first_knots[lane]) - 1;  // as counted, even if this pass rounds differently
  write_strand(part, kept, placed, drawn, first_knots[lane]);
}
