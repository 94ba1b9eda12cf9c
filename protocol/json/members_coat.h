// The coat on the wire.
#pragma once

#include "protocol/commands/coat.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, RampStop>& c) {
  v.type("RampStop");
  v.number(required("at"), c.at, share, "0 root, 1 tip; rises from stop to stop.");
  v.colour(required("colour"), c.colour);
}

template <class V>
void members(V& v, Visited<V, Undercoat>& c) {
  v.type("Undercoat", "Short, fine strands under the others.");
  v.number("share", c.share, share, "Of the strands.");
  v.number("length", c.length, {0.02, 1}, "Over the overcoat's.");
  v.number("width", c.width, {0.05, 4}, "Over the overcoat's.");
  v.number("lightness", c.lightness, {0, 4}, "Factor on the ramp's colour.");
  v.number("tint", c.tint, share, "How far `colour` replaces the ramp's.");
  v.colour("colour", c.colour);
}

template <class V>
void members(V& v, Visited<V, Ticking>& c) {
  v.type("Ticking", "Ticking: hairs of one colour of their own.");
  v.number("share", c.share, share, "Of the strands.");
  v.colour("colour", c.colour);
}

template <class V>
void members(V& v, Visited<V, Tufts>& c) {
  v.type("Tufts",
         "Clumps larger than the tile, gathered about places on the body, so that the fur does not repeat and has form "
         "at a distance. Each finer scale is .45 of the one before.");
  v.number("gather", c.gather, share, "How far tips go to the middle of their tuft.");
  v.number("size", c.size, {0.01, 1}, "Mean distance of the largest tufts, sizes.");
  v.integer("scales", c.scales, {1, 3});
  v.seed("seed", c.seed);
}

template <class V>
void members(V& v, Visited<V, Pattern>& c) {
  v.type("Pattern", "Markings by where a root is, with y up and the nose at +z; no UVs are needed.");
  v.name("kind", c.kind, json_names::pattern_kinds);
  v.number("scale", c.scale, feature_size, "From one marking to the next, sizes.");
  v.number("coverage", c.coverage, share,
           "Share of the surface that is marked; countershading: how far up it reaches.");
  v.number("contrast", c.contrast, share, "How far markings replace the coat's colour.");
  v.number("softness", c.softness, share, "Width of a marking's edge over the marking's.");
  v.number("warp", c.warp, {0, 2}, "How far noise bends the markings, in distances from one to the next.");
  v.number("legs", c.legs, share, "How far stripes turn to rings on legs and haunches, and rosettes fill there.");
  v.number("inner", c.inner, share, "How far inner_colour is seen: in rosettes, as second patches, between stripes.");
  v.number("belly", c.belly, share, "How far the underside takes belly_colour and loses its markings.");
  v.direction("axis", c.axis, "Along which stripes follow each other.");
  v.colour("colour", c.colour);
  v.colour("inner_colour", c.inner_colour);
  v.colour("belly_colour", c.belly_colour);
  v.seed("seed", c.seed);
}

template <class V>
void members(V& v, Visited<V, Variation>& c) {
  v.type("Variation", "How much colour and form change slowly over the body.");
  v.number("lightness", c.lightness, share, "1: from half to twice.");
  v.number("hue", c.hue, share, "1: from a third towards blue to a third towards red.");
  v.number("length", c.length, share, "1: from none to twice.");
  v.number("lean", c.lean, share, "1: the whole range of the inclination.");
  v.number("size", c.size, feature_size, "From one swell to the next, sizes.");
}

template <class V>
void members(V& v, Visited<V, Coat>& c) {
  v.type("Coat", "How the strands of the sample tile are made. What is not given takes its default.");
  v.integer("count", c.count, {1, 100000}, "Strands in the tile.");
  v.number("tile", c.tile, {0.01, 1}, "Side of the tile, sizes.");
  v.number("width_root", c.width_root, {0, 0.05}, "Sizes.");
  v.number("width_tip", c.width_tip, {0, 0.05}, "Sizes.");
  v.number("bend", c.bend, {0, 2}, "How far a strand bows to a side, in strand lengths.");
  v.number("curl", c.curl, {0, 0.5}, "Radius of the strand's helix, in strand lengths.");
  v.number("curl_turns", c.curl_turns, {0, 20}, "Turns of the helix from root to tip.");
  v.number("curl_together", c.curl_together, share, "How far the strands of a clump curl as one lock.");
  v.number("wave", c.wave, {0, 0.5}, "Amplitude of a sine in one plane, in strand lengths.");
  v.number("wave_turns", c.wave_turns, {0, 20}, "Waves from root to tip.");
  v.number("mess", c.mess, share, "How far each strand goes and bows its own way.");
  v.number("clump", c.clump, share, "How far tips gather to the middle of their clump.");
  v.number("clump_size", c.clump_size, clump_size, "Mean distance of clumps, sizes.");
  v.number("fine_clump", c.fine_clump, share, "How far strands gather to locks inside their clump.");
  v.number("fine_clump_size", c.fine_clump_size, clump_size, "Mean distance of these locks, sizes.");
  v.number("lodge", c.lodge, share, "How far patches of strands are pressed to one side.");
  v.number("lodge_size", c.lodge_size, clump_size, "Mean distance of these patches, sizes.");
  v.number("wetness", c.wetness, share,
           "Tighter clumps, darker (absorption up to 1.8 times) and shinier fur (highlight up to twice as strong).");
  v.number("length_spread", c.length_spread, share, "Share of the length that is random.");
  v.number("warmth_spread", c.warmth_spread, share,
           "Change of hue from strand to strand, to red and to blue, at the same lightness: 1 is up to twice the one "
           "over the other.");
  v.number("colour_spread", c.colour_spread, share, "Change of lightness from strand to strand.");
  v.number("root_share", c.root_share, share, "Angle at the root over angle at the tip: 0 plush, .6 sleek.");
  v.name("lean_curve", c.lean_curve, json_names::lean_curves, "arc, or root: y = K sqrt(x).");
  v.objects("ramp", c.ramp, {1, limits::ramp_stops}, "Colour along the strand.");
  v.object("undercoat", c.undercoat);
  v.object("ticking", c.ticking);
  v.object("tufts", c.tufts);
  v.object("pattern", c.pattern);
  v.object("variation", c.variation);
  v.seed("seed", c.seed);
}

}  // namespace pelage::json_parts
