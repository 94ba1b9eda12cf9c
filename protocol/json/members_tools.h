// JSON members of the tools.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/json/members_stroke.h"

namespace pelage::json_parts {

/// Visits the members that say which edit layer stores a tool's change, and which coats it changes.
template <class V, class Tool>
void layer_member(V& v, Tool& c) {
  v.text(sparse("edit_layer"), c.edit_layer,
         "Edit layer that stores the change. Default: the groom below all edit layers.");
  v.texts(sparse("coats"), c.coats, "Names of the coats to change. Default: all that are not muted.");
}

/// Visits the members that say where a tool works and what stores its change.
template <class V, class Tool>
void stroke_members(V& v, Tool& c) {
  v.object(NeedsStroke<Tool> ? required("stroke") : "stroke", c.stroke);
  v.object("brush", c.brush);
  layer_member(v, c);
}

template <class V, class Tool>
void flood_member(V& v, Tool& c) {
  v.boolean("flood", c.flood, "Works everywhere, without a stroke.");
}

template <class V>
void members(V& v, Visited<V, Comb>& c) {
  v.type("Comb", "Combs fur along the stroke; as a flood, everywhere along `direction`.");
  stroke_members(v, c), flood_member(v, c);
  v.number("lean", c.lean, share, "Inclination that combing tends to: 0 upright, 1 lying.");
  v.boolean("keep_inclination", c.keep_inclination, "Turns the heading only; the inclination stays.");
  v.direction("direction", c.direction, "Direction that a flood combs to; required by a flood, refused with a stroke.");
}

template <class V>
void wind_members(V& v, Visited<V, Blow>& c, MemberName source) {
  v.position(source, c.source, "Position of the wind's source.");
  v.direction("direction", c.direction, "Direction of the wind: the axis of its cone.");
  v.number("cone_degrees", c.cone_degrees, half_circle, "Half angle of the cone.");
  v.number("softness", c.softness, share, "Share of the cone over which its edge fades.");
  v.number("fall", c.fall, length_in_units,
           "Distance at which the wind has half its strength, in `units`; 0: no falloff.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
  v.number("lean", c.lean, share, "Inclination that the wind tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Blow>& c) {
  v.type("Blow",
         "Wind inside a cone, from a source or a stored blower. A stroke restricts it to what its brush covers.");
  stroke_members(v, c);
  v.text(sparse("blower"), c.blower, "Name of a blower of the scene; replaces all other wind members.");
  if (v.takes(c.blower.empty())) wind_members(v, c, bare("source"));
}

template <class V>
void stick_members(V& v, Visited<V, Attract>& c, MemberName point) {
  v.position(point, c.point, "Position of the stick.");
  v.number("radius", c.radius, length_in_units,
           "Distance beyond which nothing is pulled, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
  v.number("duration", c.duration, {0, 10000, "seconds"}, "How long the stick pulls.");
  v.number("threshold", c.threshold, {0, 1000, "share"}, "Stretch beyond which fur grows longer.");
  v.number("max_stretch", c.max_stretch, {1, 100, "factor"}, "Largest length, as a factor on the unstretched length.");
}

template <class V>
void members(V& v, Visited<V, Attract>& c) {
  v.type("Attract",
         "Pulls fur to a stick, or to a stored attractor, and stretches it. A stroke restricts it to what its brush "
         "covers.");
  stroke_members(v, c);
  v.text(sparse("attractor"), c.attractor, "Name of an attractor of the scene; replaces all other stick members.");
  if (v.takes(c.attractor.empty())) stick_members(v, c, bare("point"));
}

template <class V>
void members(V& v, Visited<V, Key>& c) {
  v.type("Key", "The fur at one position: a direction, a length or both.");
  v.position(required("position"), c.position, "Position of the key; moved to the nearest point of the surface.");
  v.direction("direction", c.direction, "Direction that fur leans in. Absent: the key sets only a length.");
  v.number("inclination", c.inclination, share,
           "How far fur leans there: 0 upright, 1 lying. Needs a direction; default 0.5.");
  v.number("length", c.length, length_in_units, "Length of the fur there, in `units`; at most 10 sizes.");
}

template <class V>
void members(V& v, Visited<V, Interpolate>& c) {
  v.type("Interpolate",
         "Spreads keys over the surface with Gaussian weights of the distance. What no key reaches keeps its value.");
  stroke_members(v, c);
  v.objects(required("keys"), c.keys, {1, limits::keys}, "The fur at a few positions.");
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.number("reach", c.reach, width_in_units,
           "Distance beyond which nothing changes, in `units`; the effect fades from half of it on. Absent: no limit.");
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds,
         "How distances are measured. straight: through space. dijkstra: along edges, too long by some percent. heat: "
         "along the surface by the heat method, slower.");
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
}

template <class V>
void members(V& v, Visited<V, Flow>& c) {
  v.type("Flow", "Lays the fur of the whole body along curves drawn on it, from the first point of each to the last.");
  stroke_members(v, c);
  v.curves(required("curves"), c.curves, {1, limits::flow_curves}, {2, limits::flow_points},
           "Curves on the model, each a list of points that fur follows from the first to the last.");
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.number("reach", c.reach, width_in_units,
           "Distance beyond which nothing changes, in `units`; the effect fades from half of it on. Absent: no limit.");
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds,
         "How distances are measured. straight: through space. dijkstra: along edges, too long by some percent. heat: "
         "along the surface by the heat method, slower.");
  v.number("inclination", c.inclination, share, "How far fur leans: 0 upright, 1 lying. Absent: unchanged.");
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
}

template <class V>
void members(V& v, Visited<V, Smooth>& c) {
  v.type("Smooth", "Blends each value with the mean of its neighbours, nearer ones counting more.");
  stroke_members(v, c), flood_member(v, c);
  v.number("t", c.t, share, "Share of the mean in each pass; above 0.5 values can oscillate.");
  v.integer("passes", c.passes, {1, limits::passes}, "Number of passes.");
  v.boolean("keep_inclination", c.keep_inclination,
            "Smooths headings alone, so that no tuft rises where opposite directions meet.");
  v.names("fields", c.fields, json_names::fields, 1, "field", "Fields that are smoothed.");
}

template <class V>
void members(V& v, Visited<V, Noise>& c) {
  v.type("Noise", "Adds random numbers that depend only on the seed and the position; inverted it subtracts them.");
  stroke_members(v, c), flood_member(v, c);
  v.seed("seed", c.seed, "Other seeds give other noise.");
  v.number("amount", c.amount, {0, 10, "varies"},
           "Amplitude of the noise: an inclination for direction; a share of the value for length, stretch, width and "
           "stiffness; for other fields in their unit.");
  v.number("feature_size", c.feature_size, length_in_units,
           "Size of the noise's features, in `units`; 0: each vertex is independent.");
  v.name("units", c.units, json_names::units);
  v.names("fields", c.fields, json_names::fields, 1, "field", "Fields that noise is added to.");
}

template <class V>
void members(V& v, Visited<V, Unify>& c) {
  v.type("Unify", "Blends fur to a value, or to the mean under the brush.");
  stroke_members(v, c), flood_member(v, c);
  v.direction("direction", c.direction, "Direction that fur is turned to.");
  v.number("inclination", c.inclination, share, "How far fur leans: 0 upright, 1 lying. Absent: unchanged.");
  v.number("length", c.length, length_in_units,
           "Length that fur tends to, in `units`; at most 10 sizes. Absent: unchanged.");
  v.name("units", c.units, json_names::units);
  v.names("mean", c.mean, json_names::fields, 0, "field", "Fields that go to their weighted mean under the brush.");
  v.number("weight", c.weight, share, "Factor on the brush's strength.");
}

template <class V>
void members(V& v, Visited<V, Part>& c) {
  v.type("Part", "A parting line: fur leans away from the stroke on both sides, inverted towards it.");
  stroke_members(v, c);
  v.number("lean", c.lean, share, "Inclination that the fur tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Whorl>& c) {
  v.type("Whorl", "Turns fur around the nearest point of the stroke: a cowlick. Inverted it turns the other way.");
  stroke_members(v, c);
  v.number("turn_degrees", c.turn_degrees, {-180, 180, "degrees"},
           "Angle of fur from outwards, counter-clockwise seen from outside: 0 points out, 90 circles, 180 points in.");
  v.number("lean", c.lean, share, "Inclination that the fur tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Length>& c) {
  v.type("Length", "Changes how long fur is.");
  stroke_members(v, c), flood_member(v, c);
  v.name("mode", c.mode, json_names::length_modes,
         "How `value` changes the length. average: to the mean under the brush. jitter: by a random share. min, max: "
         "at least, at most `value`.");
  v.number(
      "value", c.value, coordinate.in("varies"),
      "A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a share "
      "for jitter, at most 1.");
  v.name("units", c.units, json_names::units);
  v.seed("seed", c.seed, "Seed of the random shares; for jitter only.");
}

template <class V>
void members(V& v, Visited<V, TrimPlane>& c) {
  v.type("TrimPlane", "A plane; fur beyond it is cut off.");
  v.position(required("point"), c.point, "A point of the plane.");
  v.direction("normal", c.normal, "Normal of the plane, on the side that is cut off.");
}

template <class V>
void members(V& v, Visited<V, TrimSphere>& c) {
  v.type("TrimSphere", "A sphere that cuts fur at its surface.");
  v.position(required("centre"), c.centre, "Centre of the sphere.");
  v.number("radius", c.radius, length_in_units, "Radius of the sphere, in `units`; at most 1000000 sizes.");
  v.boolean("keep_inside", c.keep_inside, "True: fur is cut where it leaves the sphere; false: where it enters.");
}

template <class V>
void members(V& v, Visited<V, Trim>& c) {
  v.type("Trim",
         "Cuts fur, as it leans, by a plane, by a sphere or at a height over the skin. A flood ignores the brush's "
         "strength.");
  stroke_members(v, c), flood_member(v, c);
  v.template alternative<TrimPlane>("plane", c.shape, "Plane that fur is cut by.");
  v.template alternative<TrimSphere>("sphere", c.shape, "Sphere that fur is cut by.");
  v.alternative("height", c.shape, length_in_units,
                "Height over the skin that fur is cut to, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Lift>& c) {
  v.type("Lift", "Raises fur; inverted it lays it down. Fur that stands upright has no heading and stays.");
  stroke_members(v, c), flood_member(v, c);
}

template <class V>
void members(V& v, Visited<V, Erase>& c) {
  v.type("Erase",
         "Restores the first groom, or a checkpoint or revision of this scene; with an edit layer and neither of them, "
         "removes what that layer adds. The mask stays unless it is named.");
  stroke_members(v, c), flood_member(v, c);
  v.text(sparse("checkpoint"), c.checkpoint,
         "Name of the checkpoint to restore. Empty: the first groom, or `revision`.");
  v.counter("revision", c.revision, "Revision of this model to restore.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "Fields to restore; empty: all but the mask.");
}

template <class V>
void members(V& v, Visited<V, Clump>& c) {
  v.type("Clump", "Turns fur towards the stroke and gathers its tips; inverted it spreads them.");
  stroke_members(v, c);
  v.number("gather", c.gather, share, "How far fur turns to the stroke: 0 none, 1 fully.");
  v.number("amount", c.amount, share, "Value that the field clump tends to.");
}

template <class V>
void members(V& v, Visited<V, Curl>& c) {
  v.type("Curl", "Curls fur and turns its heading; inverted it removes the curl and turns the other way.");
  stroke_members(v, c), flood_member(v, c);
  v.number("amount", c.amount, share, "Value that the field curl tends to.");
  v.number("turn_degrees", c.turn_degrees, {-180, 180, "degrees"},
           "How far the heading turns, counter-clockwise seen from outside.");
}

template <class V>
void members(V& v, Visited<V, Paint>& c) {
  v.type("Paint", "Paints a field; inverted it restores the field's default.");
  stroke_members(v, c), flood_member(v, c);
  v.name("field", c.field, json_names::fields,
         "Field that is painted. Not direction, length or stretch, which have tools of their own.");
  v.number("value", c.value, {0, 4, "varies"},
           "Value that the field tends to; at most 4 for width and stiffness, else 1. For a colour: how much of the "
           "coat's it covers.");
  if (v.takes(shape_of(c.field).channels == 4))
    v.colour("colour", c.colour, "Colour to paint; for root_colour and tip_colour only.");
}

template <class V>
void members(V& v, Visited<V, MaskAll>&) {
  v.type("MaskAll", "Everything; an empty object.");
}

template <class V>
void members(V& v, Visited<V, MaskBox>& c) {
  v.type("MaskBox", "A box along the model's axes.");
  v.position(required("min"), c.min, "Corner with the smallest coordinates.");
  v.position(required("max"), c.max, "Corner with the largest coordinates.");
}

template <class V>
void members(V& v, Visited<V, MaskSphere>& c) {
  v.type("MaskSphere", "A sphere whose edge may be soft.");
  v.position(required("centre"), c.centre, "Centre of the sphere.");
  v.number("radius", c.radius, length_in_units, "Radius of the sphere, in `units`; at most 1000000 sizes.");
  v.number("softness", c.softness, share, "Share of the radius over which its edge fades.");
}

template <class V>
void members(V& v, Visited<V, MaskPart>& c) {
  v.type("MaskPart", "The connected part of the model nearest to a point.");
  v.position(required("position"), c.position, "A point near the part.");
}

template <class V>
void members(V& v, Visited<V, MaskMaterial>& c) {
  v.type("MaskMaterial", "All faces to which the model's file gives a material.");
  v.label(required("name"), c.name, "One of the scene's `materials`.");
}

template <class V>
void members(V& v, Visited<V, MaskPicture>& c) {
  v.type("MaskPicture",
         "An uploaded picture, read at the vertices' texture coordinates. luminance: Rec. 709 weights of the file's "
         "numbers, not linearized.");
  v.picture(required("name"), c.name, "Name that the upload of the picture returned.");
  v.name("channel", c.channel, json_names::picture_channels, "Channel of the picture that is read.");
}

template <class V>
void members(V& v, Visited<V, ApplyMap>& c) {
  v.type("Map",
         "Sets a field from a picture: each vertex takes the picture's value at its texture coordinates; on seams, the "
         "mean of its islands' values. Or from a list with a value per vertex. The mask applies, unless it is the "
         "field that is set. A batch reads at most 8 different pictures.");
  v.picture(required("picture"), c.picture, "Name that the upload of the picture returned.");
  v.name("field", c.field, json_names::fields, "Field that is set.");
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units,
           "Value of 1 in the picture, in the field's unit; for fast_fur of the width, for vector of the length.");
  v.name("units", c.units, json_names::units,
         "Unit of `scale` if it is a length. relative: sizes; world: the model's unit.");
  v.number("strength", c.strength, share, "Blend from the field to the picture: 0 none, 1 full.");
  v.integer("tile", c.tile, {0, last_udim},
            "UDIM tile of the picture, from 1001: only vertices in it change. 0: the picture repeats, and all vertices "
            "change.");
  layer_member(v, c);
}

template <class V>
void members(V& v, Visited<V, ChangeMask>& c) {
  v.type("Mask",
         "Sets where tools work: fully where the mask is 1, not at all where it is 0. The tool `paint` brushes it. "
         "Only select takes a shape, `combine` and `value`; only grow and shrink `distance`; only smooth `passes`.");
  v.name("action", c.action, json_names::mask_actions,
         "What is done with the mask: select sets it by a shape, grow and shrink move its edge, smooth blurs it, "
         "invert makes it 1 - mask.");
  if (v.takes(c.action == MaskAction::select)) {
    v.template alternative<MaskAll>("all", c.shape, "Selects everything; the default shape.");
    v.vertices("vertices", c.shape, "Indices of the vertices to select.");
    v.template alternative<MaskBox>("box", c.shape, "Selects what lies in a box.");
    v.template alternative<MaskSphere>("sphere", c.shape, "Selects what lies in a sphere.");
    v.template alternative<MaskPart>("part", c.shape);
    v.template alternative<MaskMaterial>("material", c.shape);
    v.template alternative<MaskPicture>("picture", c.shape);
    v.name("combine", c.combine, json_names::mask_combines,
           "How the shape combines with the present mask. replace: the rest becomes 1 - `value`.");
    v.number("value", c.value, share, "Mask value of the selection.");
  }
  if (v.takes(c.action == MaskAction::grow || c.action == MaskAction::shrink)) {
    v.number("distance", c.distance, length_in_units,
             "How far the edge moves along edges of the mesh, in `units`; at most 1000000 sizes.");
  }
  if (v.takes(c.action == MaskAction::smooth))
    v.integer("passes", c.passes, {1, limits::passes}, "Number of smoothing passes.");
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Retarget>& c) {
  v.type("Retarget",
         "Copies the fields of another scene, or of this one at another revision, from the nearest points of its "
         "surface. The mask applies.");
  v.label(required("scene"), c.scene, "Id of the source scene, on the same server.");
  v.counter("revision", c.revision, "Revision of the source's model; default: the present one.");
  v.name("align", c.align, json_names::alignments,
         "How the models are aligned. box: one's box is scaled to the other's, axis by axis; lengths stay shares of "
         "the size. none: coordinates are taken as they are; lengths keep their value in the model's unit.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "Fields to copy; empty: all but the mask.");
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
  layer_member(v, c);
}

}  // namespace pelage::json_parts
