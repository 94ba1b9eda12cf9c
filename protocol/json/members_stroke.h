// JSON members of cameras, views, strokes, symmetries and brushes.
#pragma once

#include "protocol/commands/stroke.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, Camera>& c) {
  v.type("Camera",
         "An automatic view, or a pinhole camera whose `position` differs from its `target` and whose `up` is not "
         "along the view.");
  if (v.has("auto", c.automatic != AutoView::none))
    return v.name(required("auto"), c.automatic, json_names::auto_views);
  v.position(required("position"), c.position, "Position of the camera.");
  v.position(required("target"), c.target, "Point that the camera looks at.");
  v.direction("up", c.up, "Direction that is up in the picture.");
  v.number("fov_degrees", c.fov_degrees, fov_degrees, "Vertical field of view.");
}

template <class V>
void members(V& v, Visited<V, View>& c) {
  v.type("View", "Camera and size of a picture.");
  v.object("camera", c.camera);
  v.integer("width", c.width, pixels, "Width of the picture.");
  v.integer("height", c.height, pixels, "Height of the picture.");
}

template <class V>
void members(V& v, Visited<V, StrokeSample>& c) {
  v.type("Sample", "A point of a stroke: a position, a pixel of its view, or a triangle with barycentrics.");
  v.sample_position(c.position);
  v.number("pressure", c.pressure, share, "Scales the brush's strength.");
  v.number("time", c.time, {0, 1000000, "seconds"}, "Time of the sample; never before that of the previous sample.");
}

template <class V>
void members(V& v, Visited<V, Stroke>& c) {
  v.type("Stroke", "Path of a brush, as samples in order. It can be sent in parts.");
  v.text("id", c.id, "Parts with the same id form one undo step. Empty for a stroke sent whole. At most 200 bytes.");
  v.seed("part", c.part, "Number of the part, from 0.");
  v.boolean("last", c.last, "Whether this is the last part.");
  v.object("view", c.view,
           "Required by pixel samples, radii in pixels and falloff_shape screen; its camera decides which faces are "
           "front-facing.");
  v.objects(required("samples"), c.samples, {1, limits::samples_per_stroke}, "Points that the brush passes, in order.");
}

template <class V>
void members(V& v, Visited<V, Plane>& c) {
  v.type("Plane", "A mirror plane.");
  v.position("point", c.point, "A point of the plane.");
  v.direction("normal", c.normal, "Normal of the plane.");
}

template <class V>
void members(V& v, Visited<V, Symmetry>& c) {
  v.type("Symmetry", "Mirror planes, all their combinations, and a rotation about an axis by equal steps.");
  v.objects(required("planes"), c.planes, {0, limits::symmetry_planes}, "Mirror planes.");
  v.position("axis_point", c.axis_point, "A point of the axis of rotation.");
  v.direction("axis", c.axis, "Direction of the axis of rotation.");
  v.integer("count", c.count, {1, limits::symmetry_images}, "Number of equal steps in a whole turn; 1 is no rotation.");
}

template <class V>
void members(V& v, Visited<V, Brush>& c) {
  v.type("Brush", "Reach and strength of a tool around a stroke.");
  v.number("radius", c.radius, length_in_units, "Radius of a dab, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::radius_units,
         "Unit of the radius. relative: sizes. world: the model's unit. pixels: pixels of the stroke's view, at the "
         "depth of each dab.");
  v.name("falloff_shape", c.falloff_shape, json_names::falloff_shapes,
         "How distances from a dab are measured. volume: through space. surface: along the surface, so parts that are "
         "near only in space are not reached. screen: in the picture of the stroke's view.");
  v.name("reach", c.reach, json_names::reaches,
         "What the radius applies to. fur: strands that come within it; with falloff_shape volume only. skin: skin "
         "within it, with its fur. Default: fur for pixel samples with falloff_shape volume, which then hit the "
         "visible fur; else skin.");
  v.name("falloff", c.falloff, json_names::falloffs, "How the effect fades from the middle of a dab to its rim.");
  v.numbers(sparse("falloff_points"), c.falloff_points, share, {2, limits::falloff_points},
            "Weights at even distances from the middle to the rim, linear between them; replace `falloff`.");
  v.number("strength", c.strength, share, "Strength of a dab: 0 none, 1 full.");
  v.number("spacing", c.spacing, {0.01, 10, "radii"}, "Distance from dab to dab. A stroke takes at most 100000 dabs.");
  v.number("pressure_to_radius", c.pressure_to_radius, share, "Share of the radius that a sample's pressure scales.");
  v.number("pressure_to_strength", c.pressure_to_strength, share,
           "Share of the strength that a sample's pressure scales.");
  v.boolean("front_faces_only", c.front_faces_only,
            "Leaves out faces that are back-facing for the camera of the stroke's view; without a view, those that "
            "face away from the surface's normal at the dab.");
  v.number("cut_off_degrees", c.cut_off_degrees, half_circle,
           "Angle from the front beyond which faces count as back-facing.");
  v.boolean("invert", c.invert, "Does the tool's opposite; refused where it has none.");
  v.number("strand_from", c.strand_from, share,
           "Start of the part of the strand that changes: 0 root, 1 tip. For colours only: root_colour is the lower "
           "half, tip_colour the upper.");
  v.number("strand_to", c.strand_to, share, "End of the part of the strand that changes; above `strand_from`.");
  v.picture(sparse("alpha"), c.alpha,
            "Name of an uploaded picture that each dab prints, its top in the stroke's direction. White has the full "
            "effect, black none.");
  v.object("symmetry", c.symmetry,
           "Symmetry of this command; default: the scene's. Empty `planes` and `count` 1: no symmetry.");
}

}  // namespace pelage::json_parts
