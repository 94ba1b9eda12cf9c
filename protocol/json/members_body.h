// What is placed on a model, on the wire: eyes, curves and bare skin.
#pragma once

#include "protocol/commands/curves.h"
#include "protocol/commands/eye.h"
#include "protocol/commands/skin.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

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

}  // namespace pelage::json_parts
