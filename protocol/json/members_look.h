// Coats, bodies, looks and lights on the wire.
//
// The coat on the wire.
#pragma once

#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/look.h"
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

// What is placed on a model, on the wire: eyes, curves and bare skin.

template <class V>
void members(V& v, Visited<V, Iris>& c) {
  v.type("Iris");
  v.colour("colour", c.colour, "Tints the grey fibres.");
  v.colour("inner_colour", c.inner_colour, "Around the pupil.");
  v.number("size", c.size, {0.1, 0.95}, "Radius of the disc, in radii of the eye.");
  v.number("depth", c.depth, {0, 0.5}, "Of the disc below the cornea's rim, in radii of the eye.");
  v.number("relief", c.relief, {0, 0.2}, "Height of the fibres, in radii of the eye; held at the depth.");
  v.number("limbal_ring", c.limbal_ring, share, "Darkness of the ring around the iris.");
  v.number("turn_degrees", c.turn_degrees, {-360, 360}, "Of the fibres around the axis, degrees.");
}

template <class V>
void members(V& v, Visited<V, Pupil>& c) {
  v.type("Pupil");
  v.name("shape", c.shape, json_names::pupil_shapes);
  v.number_or("automatic", "size", c.size, share,
              "Share of the iris: 0 closed, 1 all of it. `automatic` answers the light.");
}

template <class V>
void members(V& v, Visited<V, Lids>& c) {
  v.type(
      "Lids",
      "Skin around the eye that leaves an almond open, and shades what lies under it. Angles are seen from the eye's "
      "centre. Without this block the eye has no lids.");
  v.direction("facing", c.facing, "Middle of the opening; where the eye looks when it is not given.");
  v.number("width_degrees", c.width_degrees, {1, 90}, "From the middle to a corner.");
  v.number("upper_degrees", c.upper_degrees, {-90, 90}, "From the middle up to the upper lid.");
  v.number("lower_degrees", c.lower_degrees, {-90, 90}, "From the middle down to the lower lid.");
  v.number("tilt_degrees", c.tilt_degrees, {-180, 180}, "Counter-clockwise, seen from the front.");
  v.colour("colour", c.colour);
}

template <class V>
void members(V& v, Visited<V, Eye>& c) {
  v.type("Eye",
         "A ball with a bulging cornea. Lengths of its parts are in its radii. It takes a gaze or a point to look at.");
  v.position(required("position"), c.position, "Of the ball's centre.");
  v.number(required("radius"), c.radius, {limits::min_eye_radius, 1e6}, "Sizes.");
  if (v.shows(!c.look_at)) v.direction("gaze", c.gaze, "Where it looks.");
  v.position("look_at", c.look_at, "The point that it looks at; not its own position.");
  v.object("iris", c.iris);
  v.object("pupil", c.pupil);
  v.object("lids", c.lids);
  v.colour("sclera", c.sclera, "The white of the eye.");
  v.number("bulge", c.bulge, share, "Of the cornea: 0 none, 1 half a ball.");
  v.number("refraction", c.refraction, {1, 3}, "Refractive index of the cornea.");
  v.number("wetness", c.wetness, share, "How sharp the tear film reflects: 0 a broad sheen, 1 a mirror.");
}

template <class V>
void members(V& v, Visited<V, CurveGroup>& c) {
  v.type("CurveGroup",
         "Curves of one kind. Guides are drawn as they are given, and between each two that follow each other more are "
         "filled in. They take the look's shading model, cast no shadow, and of the AOVs of an EXR are in beauty and "
         "alpha alone.");
  v.curves(required("curves"), c.curves, {1, limits::curves}, {2, limits::curve_points},
           "Guides: the points that a smooth curve passes through, root first.");
  v.number("width_root", c.width_root, {0, 0.1}, "Sizes.");
  v.number("width_tip", c.width_tip, {0, 0.1}, "Sizes.");
  v.colour("root_colour", c.root_colour);
  v.colour("tip_colour", c.tip_colour);
  v.integer("fill", c.fill, {0, limits::curves - 1}, "Curves between each two guides that follow each other.");
  v.number(
      "spread", c.spread, share,
      "How far filled curves stray: at 1 half of their length, 30 degrees, and half of the way to the next curve.");
  v.seed("seed", c.seed);
}

template <class V>
void members(V& v, Visited<V, SkinFacing>& c) {
  v.type("SkinFacing",
         "Only skin whose normal lies near a direction belongs to the region. Without this block all of it does.");
  v.direction(required("direction"), c.direction);
  v.number("angle_degrees", c.angle_degrees, half_circle, "From the direction, where the region is whole.");
  v.number("fade_degrees", c.fade_degrees, half_circle, "Over which it ends beyond that.");
}

template <class V>
void members(V& v, Visited<V, SkinBumps>& c) {
  v.type("SkinBumps", "Leathery relief: cells with creases between them.");
  v.number("height", c.height, {0, 0.1}, "Sizes.");
  v.number("size", c.size, {0.0001, 1}, "Of a cell, sizes.");
}

template <class V>
void members(V& v, Visited<V, SkinRegion>& c) {
  v.type("SkinRegion",
         "An ellipsoid: skin inside it has no fur and a look of its own. Where regions meet, the later lies over the "
         "earlier.");
  v.position(required("centre"), c.centre);
  v.vector(required("radii"), c.radii, {limits::min_skin_radius, 1e6},
           "Sizes. The third lies along the axis, the first is level, the second is upright where the axis is level.");
  v.direction("axis", c.axis, "Of the third radius.");
  v.number("turn_degrees", c.turn_degrees, {-180, 180}, "Around the axis, counter-clockwise as seen from its tip.");
  v.number(
      "softness", c.softness, {0, 10},
      "How far outside the region fur takes to reach its whole length, in the region's radii. The colour ends within "
      "half of that.");
  v.object("facing", c.facing);
  v.colour("colour", c.colour);
  v.number("shine", c.shine, share, "Reflectance: 0 none, 0.5 that of skin, 1 twice that.");
  v.number("roughness", c.roughness, {0.02, 1}, "Width of the highlight.");
  v.number("wetness", c.wetness, share, "A clear film: darker, with a sharp highlight.");
  v.number("scatter", c.scatter, share, "How far light wraps around, red the furthest.");
  v.object("bumps", c.bumps);
}

// How a scene is shaded and lit, on the wire.

template <class V>
void members(V& v, Visited<V, FibreOptics>& c) {
  v.type("Fibre", "Fibres as the models energy_conserving, marschner and scheuermann take them.");
  v.number("longitudinal_roughness", c.longitudinal_roughness, share, "beta_m; energy_conserving.");
  v.number("azimuthal_roughness", c.azimuthal_roughness, share, "beta_n; energy_conserving.");
  v.number("cuticle_tilt", c.cuticle_tilt, {-15, 15}, "Degrees; turns reflected light to the root.");
  v.number("refractive_index", c.refractive_index, {1, 3});
  v.name("absorption", c.absorption, json_names::absorptions, "What the absorption is worked out from.");
  v.number("eumelanin", c.eumelanin, {0, 10000}, "Brown and black.");
  v.number("pheomelanin", c.pheomelanin, {0, 10000}, "Red.");
  v.number("highlight_width", c.highlight_width, {0, 90}, "Degrees; marschner.");
  v.number("caustic_width", c.caustic_width, {1, 60}, "Degrees; marschner.");
  v.number("primary_shift", c.primary_shift, {-2, 2}, "Above 0: highlight nearer the tip; scheuermann.");
  v.number("secondary_shift", c.secondary_shift, {-2, 2}, "scheuermann.");
  v.number("shift_spread", c.shift_spread, {0, 2}, "From strand to strand; scheuermann.");
  v.number("secondary_specular", c.secondary_specular, {0, 4}, "Of the coloured lobe; scheuermann.");
  v.number("secondary_exponent", c.secondary_exponent, {0, 1000000}, "scheuermann.");
}

template <class V>
void members(V& v, Visited<V, Look>& c) {
  v.type("Look", "How fur is shaded. What is not given takes its default.");
  v.name("shading", c.shading, json_names::shading_models, "How fibres scatter light.");
  v.object("fibre", c.fibre);
  v.name("colour_source", c.colour_source, json_names::colour_sources,
         "model: its texture or vertex colours; coat: the ramp; automatic: the model's where it has colours.");
  v.number("ambient", c.ambient, {0, 4});
  v.number("diffuse", c.diffuse, {0, 4});
  v.number("specular", c.specular, {0, 4});
  v.number("diffuse_exponent", c.diffuse_exponent, {0, 1000000});
  v.number("specular_exponent", c.specular_exponent, {0, 1000000});
  v.number("back_attenuation", c.back_attenuation, {0.001, 1});
  v.number("ambient_floor", c.ambient_floor, share, "Ambient light that reaches the roots.");
  v.number("self_shadow", c.self_shadow, {0, 4}, "Scales the optical depth to the light.");
  v.colour("skin", c.skin, "Colour under the fur where the model has none.");
}

template <class V>
void members(V& v, Visited<V, Light>& c) {
  v.type("Light");
  v.name("kind", c.kind, json_names::light_kinds,
         "area: a rectangle that shines along `direction` by the cosine, as bright from afar as a point light. Shells "
         "see it from its middle.");
  v.direction("direction", c.direction, "Where a directional, spot or area light goes.");
  v.position("position", c.position, "Of a point, spot or area light.");
  v.colour("colour", c.colour);
  v.number("intensity", c.intensity, {0, 100000000},
           "1 gives white; a point light's is measured at a distance of one size.");
  v.number("cone_degrees", c.cone_degrees, {0.1, 90}, "Half angle of a spot light.");
  v.number("cone_softness", c.cone_softness, share, "Share of the cone over which a spot light fades.");
  v.number("angle_degrees", c.angle_degrees, {0, 90},
           "Half angle that a directional light spans, for traced strands and a `penumbra`.");
  v.number("radius", c.radius, {0, 10},
           "Of the ball that a point or spot light is, sizes, for traced strands and a `penumbra`.");
  v.number("width", c.width, {0.001, 100}, "Of an area light, sizes; level.");
  v.number("height", c.height, {0.001, 100}, "Of an area light, sizes.");
  v.boolean("self_shadow_maps", c.self_shadow_maps,
            "Shadow maps of the shells in place of the estimate, in frames with `shadow_maps`.");
  v.name("cast_shadow", c.cast_shadow, json_names::cast_shadows,
         "Shadow of one part of the body on another, in frames with `shadow_maps`: with a sharp edge, with one that "
         "`shadow_scale` widens, or blurred by the light's size, nearest to traced strands.");
  v.number("shadow_scale", c.shadow_scale, {0, 1000}, "Larger makes the edge of a `soft` cast shadow narrower.");
}

template <class V>
void turn_member(V& v, Visited<V, Environment>& c) {
  v.number("turn_degrees", c.turn_degrees, {-360, 360}, "About +y, counter-clockwise seen from above; of harmonics.");
}

template <class V>
void intensity_member(V& v, Visited<V, Environment>& c) {
  v.number("intensity", c.intensity, {0, 100}, "Factor on its light.");
}

template <class V>
void members(V& v, Visited<V, Environment>& c) {
  v.type(
      "Environment",
      "Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white everywhere is "
      "constant light.");
  if (v.shows(!c.harmonics)) {
    v.colour("sky", c.sky, "From straight above.");
    v.colour("horizon", c.horizon);
    v.colour("ground", c.ground, "From straight below.");
  }
  v.vectors("harmonics", c.harmonics, {-limits::harmonic, limits::harmonic}, "In place of the three colours.");
  if (v.shows(c.harmonics.has_value())) turn_member(v, c);
  intensity_member(v, c);
}

template <class V>
void members(V& v, Visited<V, Ground>& c) {
  v.type("Ground", "A level ground that catches shadow. It darkens the background and shows nothing else.");
  v.boolean("visible", c.visible);
  v.number("height", c.height, coordinate, "The model's y; its lowest point when absent.");
  v.number("shadow", c.shadow, share, "How dark cast shadows get on it, in frames with `shadow_maps`.");
  v.number("contact", c.contact, share, "How dark it gets under the model.");
}

}  // namespace pelage::json_parts
