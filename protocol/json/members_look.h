// JSON members of coats, bodies, looks, lights and wind.
#pragma once

#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/look.h"
#include "protocol/commands/wind.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, RampStop>& c) {
  v.type("RampStop", "A colour at a position along the strand.");
  v.number(required("at"), c.at, share, "Position along the strand: 0 root, 1 tip. It rises from stop to stop.");
  v.colour(required("colour"), c.colour, "Colour of the strand there.");
}

template <class V>
void members(V& v, Visited<V, Undercoat>& c) {
  v.type("Undercoat", "Short, fine strands under the others.");
  v.number("share", c.share, share, "Share of the strands that belong to it.");
  v.number("length", c.length, {0.02, 1, "factor"}, "Factor on the overcoat's length.");
  v.number("width", c.width, {0.05, 4, "factor"}, "Factor on the overcoat's width.");
  v.number("lightness", c.lightness, {0, 4, "factor"}, "Factor on the ramp's colour.");
  v.number("tint", c.tint, share, "How far `colour` replaces the ramp's.");
  v.colour("colour", c.colour, "Colour that `tint` mixes in.");
}

template <class V>
void members(V& v, Visited<V, Ticking>& c) {
  v.type("Ticking", "Single hairs that have a colour of their own.");
  v.number("share", c.share, share, "Share of the overcoat's strands that have it.");
  v.colour("colour", c.colour, "Colour of these hairs.");
}

template <class V>
void members(V& v, Visited<V, Tufts>& c) {
  v.type("Tufts",
         "Clumps larger than the tile, around points of the body, so that the fur does not repeat and has form at a "
         "distance. Each finer scale is .45 of the one before.");
  v.number("gather", c.gather, share, "How far tips move to the middle of their tuft; at 1 by .6 of the distance.");
  v.number("size", c.size, {0.01, 1, "sizes"}, "Mean distance between the largest tufts.");
  v.integer("scales", c.scales, {1, 3}, "Number of scales of tufts.");
  v.seed("seed", c.seed, "Other seeds give other tufts.");
}

template <class V>
void members(V& v, Visited<V, Pattern>& c) {
  v.type("Pattern", "Markings by a root's position, with y up and the nose at +z; they need no UVs.");
  v.name("kind", c.kind, json_names::pattern_kinds, "Kind of the markings.");
  v.number("scale", c.scale, feature_size, "Distance from one marking to the next.");
  v.number("coverage", c.coverage, share,
           "Share of the surface that is marked; for countershading how far up it reaches.");
  v.number("contrast", c.contrast, share, "How far markings replace the coat's colour.");
  v.number("softness", c.softness, share, "Width of a marking's edge over the marking's width.");
  v.number("warp", c.warp, {0, 2, "markings"}, "How far noise bends the markings, in distances from one to the next.");
  v.number("legs", c.legs, share,
           "How far stripes become rings on legs and haunches, and rosettes solid spots on legs.");
  v.number("inner", c.inner, share, "Strength of `inner_colour`: in rosettes, as second patches, between stripes.");
  v.number("belly", c.belly, share, "How far the underside takes `belly_colour` and loses its markings.");
  v.direction("axis", c.axis, "Direction from one stripe to the next.");
  v.colour("colour", c.colour, "Colour of the markings.");
  v.colour("inner_colour", c.inner_colour, "Colour inside rosettes, of second patches and between stripes.");
  v.colour("belly_colour", c.belly_colour, "Colour of the belly.");
  v.seed("seed", c.seed, "Other seeds give other markings.");
}

template <class V>
void members(V& v, Visited<V, Variation>& c) {
  v.type("Variation", "How much colour and form change slowly over the body.");
  v.number("lightness", c.lightness, share, "How much lightness changes; at 1 from half to twice.");
  v.number("hue", c.hue, share, "How much hue changes; at 1 from a third towards blue to a third towards red.");
  v.number("length", c.length, share, "How much length changes; at 1 from none to twice.");
  v.number("lean", c.lean, share, "How much the inclination changes; at 1 over its whole range.");
  v.number("size", c.size, feature_size, "Distance from one crest to the next.");
}

template <class V>
void members(V& v, Visited<V, Coat>& c) {
  v.type("Coat", "How the strands of the sample tile are made. What is not given takes its default.");
  v.integer("count", c.count, {1, 100000}, "Strands in the tile.");
  v.number("tile", c.tile, {0.01, 1, "sizes"}, "Side of the tile.");
  v.number("width_root", c.width_root, {0, 0.05, "sizes"}, "Width of a strand at its root.");
  v.number("width_tip", c.width_tip, {0, 0.05, "sizes"}, "Width of a strand at its tip.");
  v.number("bend", c.bend, {0, 2, "times 0.03 sizes"}, "How far a strand bows to a side; at most by its length.");
  v.number("curl", c.curl, {0, 0.5, "times 0.03 sizes"}, "Radius of the strand's helix.");
  v.number("curl_turns", c.curl_turns, {0, 20, "turns"}, "Turns of the helix from root to tip.");
  v.number("curl_together", c.curl_together, share, "How far the strands of a clump curl as one lock.");
  v.number("wave", c.wave, {0, 0.5, "times 0.03 sizes"}, "Amplitude of a sine in one plane.");
  v.number("wave_turns", c.wave_turns, {0, 20, "waves"}, "Waves from root to tip.");
  v.number("mess", c.mess, share, "How far strands lean and bow each their own way.");
  v.number("clump", c.clump, share, "How far tips gather to the middle of their clump.");
  v.number("clump_size", c.clump_size, clump_size, "Mean distance between clumps.");
  v.number("fine_clump", c.fine_clump, share, "How far strands gather to locks inside their clump.");
  v.number("fine_clump_size", c.fine_clump_size, clump_size, "Mean distance between the locks inside a clump.");
  v.number("lodge", c.lodge, share, "How far patches of strands are pressed to one side.");
  v.number("lodge_size", c.lodge_size, clump_size, "Mean distance between the pressed patches.");
  v.number("wetness", c.wetness, share,
           "How wet the coat is: tighter clumps, darker (absorption up to 1.8 times) and shinier fur (highlight up to "
           "twice as strong).");
  v.number("length_spread", c.length_spread, share, "Share of the length that is random.");
  v.number("warmth_spread", c.warmth_spread, share,
           "Change of hue from strand to strand, to red or blue, at the same lightness; at 1 red over blue goes from "
           "half to twice.");
  v.number("colour_spread", c.colour_spread, share, "Change of lightness from strand to strand.");
  v.number("root_share", c.root_share, share, "Angle of lean at the root over that at the tip: 0 plush, .6 sleek.");
  v.name("lean_curve", c.lean_curve, json_names::lean_curves,
         "Curve of a leaning strand. arc: a circular arc. root: bent most at the root, y = K sqrt(x).");
  v.objects("ramp", c.ramp, {1, limits::ramp_stops}, "Colour along the strand.");
  v.object("undercoat", c.undercoat);
  v.integer("guard_hairs", c.guard_hairs, {0, 100000},
            "Single hairs over the whole model that stand out of the fur, up to 1.25 times as long.");
  v.object("ticking", c.ticking);
  v.object("tufts", c.tufts);
  v.object("pattern", c.pattern);
  v.object("variation", c.variation);
  v.seed("seed", c.seed, "Other seeds give other strands.");
}

// JSON members of what is placed on a model: eyes, curves and bare skin.

template <class V>
void members(V& v, Visited<V, Iris>& c) {
  v.type("Iris", "The coloured disc of an eye.");
  v.colour("colour", c.colour, "Colour that tints the grey fibres.");
  v.colour("inner_colour", c.inner_colour, "Colour around the pupil.");
  v.number("size", c.size, {0.1, 0.95, "radii of the eye"}, "Radius of the disc.");
  v.number("depth", c.depth, {0, 0.5, "radii of the eye"}, "Depth of the disc below the cornea's rim.");
  v.number("relief", c.relief, {0, 0.2, "radii of the eye"}, "Height of the fibres, at most the depth.");
  v.number("limbal_ring", c.limbal_ring, share, "Darkness of the ring around the iris.");
  v.number("turn_degrees", c.turn_degrees, {-360, 360, "degrees"}, "Rotation of the fibres around the axis.");
}

template <class V>
void members(V& v, Visited<V, Pupil>& c) {
  v.type("Pupil", "The opening of an iris.");
  v.name("shape", c.shape, json_names::pupil_shapes, "Form of the opening.");
  v.number_or("automatic", "size", c.size, share,
              "Size as a share of the iris: 0 closed, 1 all of it. `automatic` adapts to the light.");
}

template <class V>
void members(V& v, Visited<V, Lids>& c) {
  v.type("Lids",
         "Skin around the eye with an almond-shaped opening; it shades the eye. Angles are seen from the eye's centre. "
         "Without this block the eye has no lids.");
  v.direction("facing", c.facing, "Middle of the opening; where the eye looks when it is not given.");
  v.number("width_degrees", c.width_degrees, {1, 90, "degrees"}, "Angle from the middle of the opening to a corner.");
  v.number("upper_degrees", c.upper_degrees, {-90, 90, "degrees"},
           "Angle from the middle of the opening up to the upper lid.");
  v.number("lower_degrees", c.lower_degrees, {-90, 90, "degrees"},
           "Angle from the middle of the opening down to the lower lid.");
  v.number("tilt_degrees", c.tilt_degrees, {-180, 180, "degrees"},
           "Rotation of the opening, counter-clockwise as seen from the front.");
  v.colour("colour", c.colour, "Colour of the lids.");
}

template <class V>
void members(V& v, Visited<V, Eye>& c) {
  v.type("Eye", "A ball with a bulging cornea. Lengths of its parts are in its radii. It takes `gaze` or `look_at`.");
  v.position(required("position"), c.position, "Centre of the ball.");
  v.number(required("radius"), c.radius, {limits::min_eye_radius, 1e6, "sizes"}, "Radius of the ball.");
  if (v.shows(!c.look_at)) v.direction("gaze", c.gaze, "Direction in which the eye looks.");
  v.position("look_at", c.look_at, "Point that the eye looks at; not its own position.");
  v.object("iris", c.iris, "The eye's iris.");
  v.object("pupil", c.pupil, "The eye's pupil.");
  v.object("lids", c.lids, "Skin around the eye. Without this block the eye has no lids.");
  v.colour("sclera", c.sclera, "Colour of the white of the eye.");
  v.number("bulge", c.bulge, share, "How far the cornea bulges: 0 not at all, 1 half a ball.");
  v.number("refraction", c.refraction, {1, 3, "refractive index"}, "Refractive index of the cornea.");
  v.number("wetness", c.wetness, share, "How sharp the tear film reflects: 0 a broad sheen, 1 a mirror.");
}

template <class V>
void members(V& v, Visited<V, CurveGroup>& c) {
  v.type("CurveGroup",
         "Curves of one kind. Guides are drawn as given; more are filled in between each two neighbours. They take the "
         "look's shading model, and cast shadows only where strands are traced.");
  v.curves(required("curves"), c.curves, {1, limits::curves}, {2, limits::curve_points},
           "Guides: the points that a smooth curve passes through, root first.");
  v.number("width_root", c.width_root, {0, 0.1, "sizes"}, "Width of a curve at its root.");
  v.number("width_tip", c.width_tip, {0, 0.1, "sizes"}, "Width of a curve at its tip.");
  v.colour("root_colour", c.root_colour, "Colour at the root.");
  v.colour("tip_colour", c.tip_colour, "Colour at the tip.");
  v.integer("fill", c.fill, {0, limits::curves - 1}, "Number of curves between each two neighbouring guides.");
  v.number(
      "spread", c.spread, share,
      "How far filled curves stray: at 1 by up to half their length, 30 degrees, and half the distance to the next.");
  v.seed("seed", c.seed, "Other seeds give other filled curves.");
}

template <class V>
void members(V& v, Visited<V, SkinFacing>& c) {
  v.type("SkinFacing",
         "Only skin whose normal lies near a direction belongs to the region. Without this block all of it does.");
  v.direction(required("direction"), c.direction, "Direction that the skin faces.");
  v.number("angle_degrees", c.angle_degrees, half_circle,
           "Angle from the direction within which the region has full effect.");
  v.number("fade_degrees", c.fade_degrees, half_circle, "Further angle over which the region fades out.");
}

template <class V>
void members(V& v, Visited<V, SkinBumps>& c) {
  v.type("SkinBumps", "Leathery relief: cells with creases between them.");
  v.number("height", c.height, {0, 0.1, "sizes"}, "Height of the relief.");
  v.number("size", c.size, {0.0001, 1, "sizes"}, "Size of a cell.");
}

template <class V>
void members(V& v, Visited<V, SkinRegion>& c) {
  v.type("SkinRegion",
         "An ellipsoid: skin inside it has no fur and a look of its own. Where regions overlap, the later one covers "
         "the earlier.");
  v.position(required("centre"), c.centre, "Centre of the ellipsoid.");
  v.vector(required("radii"), c.radii, {limits::min_skin_radius, 1e6, "sizes"},
           "The three radii. The third lies along the axis, the first is horizontal, the second vertical if the axis "
           "is horizontal.");
  v.direction("axis", c.axis, "Direction of the third radius.");
  v.number("turn_degrees", c.turn_degrees, {-180, 180, "degrees"},
           "Rotation around the axis, counter-clockwise as seen from its tip.");
  v.number("softness", c.softness, {0, 10, "radii of the region"},
           "Distance outside the region over which fur grows to full length. The colour fades out over half of it.");
  v.object("facing", c.facing,
           "Limits the region to skin that faces a direction. Without this block all skin inside it belongs to it.");
  v.colour("colour", c.colour, "Colour of the skin.");
  v.number("shine", c.shine, share, "Reflectance: 0 none, 0.5 that of skin, 1 twice that.");
  v.number("roughness", c.roughness, {0.02, 1, "share"}, "Width of the highlight.");
  v.number("wetness", c.wetness, share, "A clear film: darker, with a sharp highlight.");
  v.number("scatter", c.scatter, share, "How far light wraps around, red the furthest.");
  v.object("bumps", c.bumps);
}

// JSON members of how a scene is shaded and lit.

template <class V>
void members(V& v, Visited<V, FibreOptics>& c) {
  v.type("Fibre", "How fibres scatter light in the shading models energy_conserving, marschner and scheuermann.");
  v.number("longitudinal_roughness", c.longitudinal_roughness, share,
           "Roughness along the strand, beta_m. Used by energy_conserving.");
  v.number("azimuthal_roughness", c.azimuthal_roughness, share,
           "Roughness around the strand, beta_n. Used by energy_conserving.");
  v.number("cuticle_tilt", c.cuticle_tilt, {-15, 15, "degrees"},
           "Tilt of the cuticle, which shifts highlights to the root. Not used by scheuermann.");
  v.number("refractive_index", c.refractive_index, {1, 3, "refractive index"},
           "Refractive index of the strand. Used by energy_conserving and marschner.");
  v.name("absorption", c.absorption, json_names::absorptions,
         "Source of the absorption: the fur's colour, or the melanins.");
  v.number("eumelanin", c.eumelanin, {0, 10000, "concentration"},
           "Concentration of eumelanin, which makes brown and black. Used with absorption melanin.");
  v.number("pheomelanin", c.pheomelanin, {0, 10000, "concentration"},
           "Concentration of pheomelanin, which makes red. Used with absorption melanin.");
  v.number("highlight_width", c.highlight_width, {0, 90, "degrees"}, "Width of the highlight. Used by marschner.");
  v.number("caustic_width", c.caustic_width, {1, 60, "degrees"},
           "Spread of transmitted light around the strand. Used by marschner.");
  v.number("primary_shift", c.primary_shift, {-2, 2, "tangents"},
           "Shift of the white highlight; above 0 it is nearer the tip. Used by scheuermann.");
  v.number("secondary_shift", c.secondary_shift, {-2, 2, "tangents"},
           "Shift of the coloured highlight. Used by scheuermann.");
  v.number("shift_spread", c.shift_spread, {0, 2, "tangents"},
           "How much the shifts differ from strand to strand. Used by scheuermann.");
  v.number("secondary_specular", c.secondary_specular, {0, 4, "factor"},
           "Strength of the coloured highlight. Used by scheuermann.");
  v.number("secondary_exponent", c.secondary_exponent, {0, 1000000, "exponent"},
           "Sharpness of the coloured highlight. Used by scheuermann.");
}

template <class V>
void members(V& v, Visited<V, Look>& c) {
  v.type("Look", "How fur is shaded. What is not given takes its default.");
  v.name("shading", c.shading, json_names::shading_models, "How fibres scatter light.");
  v.object("fibre", c.fibre);
  v.name("colour_source", c.colour_source, json_names::colour_sources,
         "Source of the fur's colour. model: the model's texture or vertex colours. coat: the ramp. automatic: model "
         "where it has colours.");
  v.number("ambient", c.ambient, {0, 4, "factor"}, "Strength of the light from all around.");
  v.number("diffuse", c.diffuse, {0, 4, "factor"}, "Strength of diffuse light.");
  v.number("specular", c.specular, {0, 4, "factor"},
           "Strength of the highlight. Used by lengyel, kajiya, kajiya_kay and scheuermann.");
  v.number("diffuse_exponent", c.diffuse_exponent, {0, 1000000, "exponent"},
           "How fast diffuse light falls as the light aligns with the strand. Used by lengyel and kajiya.");
  v.number("specular_exponent", c.specular_exponent, {0, 1000000, "exponent"},
           "Sharpness of the highlight. Used by lengyel, kajiya, kajiya_kay and scheuermann.");
  v.number("back_attenuation", c.back_attenuation, {0.001, 1, "share"},
           "Sine of the angle behind the skin at which a light is gone. Used by lengyel, kajiya and kajiya_kay.");
  v.number("ambient_floor", c.ambient_floor, share, "Share of the ambient light that reaches the roots.");
  v.number("self_shadow", c.self_shadow, {0, 4, "factor"}, "Factor on the optical depth of fur towards a light.");
  v.colour("skin", c.skin, "Colour under the fur where the model has none.");
}

template <class V>
void members(V& v, Visited<V, Light>& c) {
  v.type("Light", "A light of the scene.");
  v.name("kind", c.kind, json_names::light_kinds,
         "Kind of the light. area: a rectangle that shines along `direction` by the cosine law, from afar as bright as "
         "a point light. Shells take its centre.");
  v.direction("direction", c.direction, "Direction in which a directional, spot or area light shines.");
  v.position("position", c.position, "Position of a point, spot or area light.");
  v.colour("colour", c.colour, "Colour of the light.");
  v.number("intensity", c.intensity, {0, 100000000, "factor"},
           "Brightness: 1 gives white, for a point or spot light at a distance of one size.");
  v.number("cone_degrees", c.cone_degrees, {0.1, 90, "degrees"}, "Half angle of a spot light.");
  v.number("cone_softness", c.cone_softness, share, "Share of the cone over which a spot light fades.");
  v.number("angle_degrees", c.angle_degrees, {0, 90, "degrees"},
           "Half angle that a directional light spans: wider lights cast softer shadows.");
  v.number("radius", c.radius, {0, 10, "sizes"},
           "Radius of a point or spot light, a ball; larger ones cast softer shadows.");
  v.number("width", c.width, {0.001, 100, "sizes"}, "Width of an area light; this side is horizontal.");
  v.number("height", c.height, {0.001, 100, "sizes"}, "Height of an area light.");
  v.boolean("self_shadow_maps", c.self_shadow_maps,
            "Self-shadow from shadow maps in place of the estimate. Only for method shells with `shadow_maps`.");
  v.name("cast_shadow", c.cast_shadow, json_names::cast_shadows,
         "Shadow of one part of the body on another. hard: a sharp edge. soft: an edge by `shadow_scale`. penumbra: "
         "blurred by the light's size. Only for method shells with `shadow_maps`; strands take every light's shadow.");
  v.number("shadow_scale", c.shadow_scale, {0, 1000, "factor"},
           "Larger makes the edge of a `soft` cast shadow narrower.");
}

template <class V>
void turn_member(V& v, Visited<V, Environment>& c) {
  v.number("turn_degrees", c.turn_degrees, {-360, 360, "degrees"},
           "Rotation of the harmonics about +y, counter-clockwise as seen from above.");
}

template <class V>
void intensity_member(V& v, Visited<V, Environment>& c) {
  v.number("intensity", c.intensity, {0, 100, "factor"}, "Factor on this light.");
}

template <class V>
void members(V& v, Visited<V, Environment>& c) {
  v.type(
      "Environment",
      "Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white everywhere is "
      "constant light.");
  if (v.shows(!c.harmonics)) {
    v.colour("sky", c.sky, "Light from straight above.");
    v.colour("horizon", c.horizon, "Light from the horizon.");
    v.colour("ground", c.ground, "Light from straight below.");
  }
  v.vectors("harmonics", c.harmonics, {-limits::harmonic, limits::harmonic, "radiance"},
            "Nine spherical harmonics of red, green and blue, in place of the three colours.");
  if (v.shows(c.harmonics.has_value())) turn_member(v, c);
  intensity_member(v, c);
}

template <class V>
void members(V& v, Visited<V, Ground>& c) {
  v.type("Ground", "A horizontal ground that catches shadows. It only darkens the background.");
  v.boolean("visible", c.visible, "Whether there is a ground.");
  v.number("height", c.height, coordinate, "The model's y of the ground; the model's lowest point when absent.");
  v.number("shadow", c.shadow, share, "Darkness of shadows that are cast on it.");
  v.number("contact", c.contact, share, "How much it darkens under the model.");
}

template <class V>
void members(V& v, Visited<V, Wind>& c) {
  v.type("Wind",
         "A wind over the whole scene, which changes the lean of fur and never its length. At speed 0 nothing moves. "
         "Upright fur .03 sizes long with a `stiffness` of 1 leans about half over in a wind of one size per second; "
         "longer or less stiff fur leans further and sways slower.");
  v.number("speed", c.speed, {0, limits::wind_speed, "sizes per second"},
           "Speed of the mean wind, and of the gusts that travel with it; 0 for none.");
  v.direction("direction", c.direction, "Direction in which the wind blows.");
  v.number("gusts", c.gusts, {0, 10, "share"}, "Strength of the gusts, as a share of `speed`.");
  v.number("turbulence", c.turbulence, {0, 10, "share"}, "Strength of the turbulence, as a share of `speed`.");
  v.number("turbulence_scale", c.turbulence_scale, {0.001, 1000, "sizes"},
           "Size of the largest eddies; gusts are four to sixteen times as long.");
  v.seed("seed", c.seed, "Other seeds give other gusts and eddies.");
  v.number("frequency", c.frequency, {0.01, 100, "hertz"}, "How often fur .03 sizes long sways.");
  v.number("damping", c.damping, {0.01, 10, "ratio"},
           "Damping of the swaying: 1 comes back without overshoot, less swings on.");
  v.number("time", c.time, moment, "Time of the scene, the default `time` of frames.");
}

}  // namespace pelage::json_parts
