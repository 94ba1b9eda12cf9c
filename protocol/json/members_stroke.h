// JSON members of cameras, views, strokes, symmetries and brushes.
#pragma once

#include "protocol/commands/stroke.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, Camera>& c) {
  v.type("Camera",
         "A view that the server frames, or a pinhole camera, whose position differs from its target and whose up is "
         "not along the view.");
  if (v.has("auto", c.automatic != AutoView::none))
    return v.name(required("auto"), c.automatic, json_names::auto_views);
  v.position(required("position"), c.position, "Where the camera stands.");
  v.position(required("target"), c.target, "Point that the camera looks at.");
  v.direction("up", c.up, "Direction that is up in the picture.");
  v.number("fov_degrees", c.fov_degrees, fov_degrees, "Vertical field of view.");
}

template <class V>
void members(V& v, Visited<V, View>& c) {
  v.type("View", "The frame that a pixel belongs to.");
  v.object("camera", c.camera);
  v.integer("width", c.width, pixels, "Width of the picture.");
  v.integer("height", c.height, pixels, "Height of the picture.");
}

template <class V>
void members(V& v, Visited<V, StrokeSample>& c) {
  v.type("Sample", "One place, as a position, a pixel of the stroke's view, or a triangle with barycentrics.");
  v.place(c.place);
  v.number("pressure", c.pressure, share, "Scales the brush's strength.");
  v.number("time", c.time, {0, 1000000, "seconds"}, "When the brush was there; never earlier than the sample before.");
}

template <class V>
void members(V& v, Visited<V, Stroke>& c) {
  v.type("Stroke", "Where a brush goes, as samples in order. It can be sent in parts.");
  v.text("id", c.id, "Parts with one id join one undo step. Empty for a stroke sent whole. At most 200 bytes.");
  v.seed("part", c.part, "Number of the part, from 0.");
  v.boolean("last", c.last, "Whether no part comes after this one.");
  v.object("view", c.view, "Required by pixel samples; front faces are then judged against it.");
  v.objects(required("samples"), c.samples, {1, limits::samples_per_stroke}, "Places that the brush passes, in order.");
}

template <class V>
void members(V& v, Visited<V, Plane>& c) {
  v.type("Plane", "A plane that mirrors.");
  v.position("point", c.point, "A point of the plane.");
  v.direction("normal", c.normal, "Direction that the plane faces.");
}

template <class V>
void members(V& v, Visited<V, Symmetry>& c) {
  v.type("Symmetry", "Mirror planes, all their combinations, and a rotation about an axis by equal steps.");
  v.objects(required("planes"), c.planes, {0, limits::symmetry_planes}, "Planes that mirror.");
  v.position("axis_point", c.axis_point, "A point of the axis of rotation.");
  v.direction("axis", c.axis, "Direction of the axis of rotation.");
  v.integer("count", c.count, {1, limits::symmetry_images}, "Number of equal steps in a whole turn; 1 is no rotation.");
}

template <class V>
void members(V& v, Visited<V, Brush>& c) {
  v.type("Brush", "How far and how strongly a tool reaches round a stroke.");
  v.number("radius", c.radius, length_in_units, "Radius of a dab, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::radius_units,
         "Unit of the radius. relative: sizes. world: the model's unit. pixels: pixels of the stroke's view, at the "
         "depth of each dab.");
  v.name("falloff_shape", c.falloff_shape, json_names::falloff_shapes,
         "How the distance of a vertex from a dab is measured: through space, along the surface (it does not reach "
         "another part of the model that is only near in space), or in the picture of the stroke's view.");
  v.name("reach", c.reach, json_names::reaches,
         "What the brush reaches: fur that itself comes within its radius, or skin within it, with the fur that stands "
         "there. fur goes with falloff_shape volume. Absent it is fur for samples in pixels, which then are places on "
         "the fur that is seen there, and skin for others.");
  v.name("falloff", c.falloff, json_names::falloffs, "How the effect fades from the middle of a dab to its rim.");
  v.numbers(sparse("falloff_points"), c.falloff_points, share, {2, limits::falloff_points},
            "Weights from the middle to the rim, straight between them, in place of the named curve.");
  v.number("strength", c.strength, share, "How much a dab changes: 0 nothing, 1 all.");
  v.number("spacing", c.spacing, {0.01, 10, "radii"}, "Distance from dab to dab. A stroke takes at most 100000 dabs.");
  v.number("pressure_to_radius", c.pressure_to_radius, share, "Share of the radius that a sample's pressure scales.");
  v.number("pressure_to_strength", c.pressure_to_strength, share,
           "Share of the strength that a sample's pressure scales.");
  v.boolean("front_faces_only", c.front_faces_only,
            "Leaves out faces that are back-facing for the camera of the stroke's view; without a view, those that "
            "face away from the surface's normal at the dab.");
  v.number("cut_off_degrees", c.cut_off_degrees, half_circle,
           "Angle to the front from which faces count as back-facing.");
  v.boolean("invert", c.invert, "Does the tool's opposite; refused where it has none.");
  v.number("strand_from", c.strand_from, share,
           "Where the part of the strand that changes begins: 0 is the root, 1 the tip. It works on colours only: "
           "root_colour stands for the lower half, tip_colour for the upper.");
  v.number("strand_to", c.strand_to, share, "Where the part of the strand that changes ends; above strand_from.");
  v.picture(sparse("alpha"), c.alpha,
            "Name of an uploaded picture that each dab of a stroke prints, its top to where the stroke goes: bright "
            "changes much, black nothing.");
  v.object("symmetry", c.symmetry,
           "The symmetry of this command; absent it is the scene's. With `planes` empty and `count` 1 there is none.");
}

}  // namespace pelage::json_parts
