// JSON members of the tools.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/json/members_stroke.h"

namespace pelage::json_parts {

/// Visits the members that say which edit layer stores a tool's change, and which coats it changes.
template <class V, class Tool>
void layer_member(V& v, Tool& c) {
  v.text(sparse("edit_layer"), c.edit_layer,
         "Edit layer that keeps what changes; the groom below all edit layers unless named.");
  v.texts(sparse("coats"), c.coats, "Coats that it works on; all that are not muted unless named.");
}

/// Visits the members that say where a tool works and what stores its change.
template <class V, class Tool>
void place_members(V& v, Tool& c) {
  v.object(NeedsStroke<Tool> ? required("stroke") : "stroke", c.stroke);
  v.object("brush", c.brush);
  layer_member(v, c);
}

template <class V, class Tool>
void flood_member(V& v, Tool& c) {
  v.boolean("flood", c.flood, "Works everywhere in place of under a stroke.");
}

template <class V>
void members(V& v, Visited<V, Comb>& c) {
  v.type("Comb", "Turns fur the way the stroke moves; as a flood, to `direction` everywhere.");
  place_members(v, c), flood_member(v, c);
  v.number("lean", c.lean, share, "Inclination that combing tends to: 0 upright, 1 lying.");
  v.boolean("keep_inclination", c.keep_inclination, "Turns the heading alone.");
  v.direction("direction", c.direction,
              "Where fur is turned to as a flood. Required by a flood, refused with a stroke.");
}

template <class V>
void wind_members(V& v, Visited<V, Blow>& c, MemberName source) {
  v.position(source, c.source, "Where the wind comes from.");
  v.direction("direction", c.direction, "Where the wind blows, the axis of its cone.");
  v.number("cone_degrees", c.cone_degrees, half_circle, "Half angle of the cone.");
  v.number("softness", c.softness, share, "Share of the cone over which its edge fades.");
  v.number("fall", c.fall, length_in_units,
           "Distance at which the wind has half its strength, in `units`; 0: it does not fall.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "How much it changes: 0 does nothing, 1 all.");
  v.number("lean", c.lean, share, "Inclination that the wind tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Blow>& c) {
  v.type("Blow",
         "Wind from a source, or from a blower that stays, inside a cone. A stroke restricts it to what its brush "
         "covers.");
  place_members(v, c);
  v.text(sparse("blower"), c.blower, "Name of a blower of the scene, in place of all that follows.");
  if (v.takes(c.blower.empty())) wind_members(v, c, bare("source"));
}

template <class V>
void stick_members(V& v, Visited<V, Attract>& c, MemberName point) {
  v.position(point, c.point, "Where the stick is.");
  v.number("radius", c.radius, length_in_units,
           "Distance beyond which nothing is pulled, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "How much it changes: 0 does nothing, 1 all.");
  v.number("duration", c.duration, {0, 10000, "seconds"}, "How long the stick pulls.");
  v.number("threshold", c.threshold, {0, 1000, "share"}, "Stretch that fur takes without growing.");
  v.number("max_stretch", c.max_stretch, {1, 100, "factor"}, "Largest length over the length before any stretch.");
}

template <class V>
void members(V& v, Visited<V, Attract>& c) {
  v.type(
      "Attract",
      "A stick, or an attractor that stays, pulls fur to it and stretches it. A stroke restricts it to what its brush "
      "covers.");
  place_members(v, c);
  v.text(sparse("attractor"), c.attractor, "Name of an attractor of the scene, in place of all that follows.");
  if (v.takes(c.attractor.empty())) stick_members(v, c, bare("point"));
}

template <class V>
void members(V& v, Visited<V, Key>& c) {
  v.type("Key", "What fur is like at one place: a direction, a length or both.");
  v.position(required("position"), c.position, "Where the key lies; the nearest place on the surface is meant.");
  v.direction("direction", c.direction, "Where fur leans there. Without it the key says a length alone.");
  v.number("inclination", c.inclination, share,
           "How far fur leans there: 0 upright, 1 lying. It needs a direction and is 0.5 unless given.");
  v.number("length", c.length, length_in_units, "Length of the fur there, in `units`; at most 10 sizes.");
}

template <class V>
void members(V& v, Visited<V, Interpolate>& c) {
  v.type("Interpolate",
         "Spreads keys over the surface with Gaussian weights of the distance. What no key reaches keeps its value.");
  place_members(v, c);
  v.objects(required("keys"), c.keys, {1, limits::keys}, "What fur is like at a few places.");
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.number(
      "reach", c.reach, width_in_units,
      "Farther away than this, in `units`, nothing changes; from half of it on the effect fades. Absent there is no "
      "end.");
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds,
         "How distances are measured. straight: through space. dijkstra: along edges, too long by some percent. heat: "
         "along the surface by the heat method, slower.");
  v.number("strength", c.strength, share, "How much it changes: 0 does nothing, 1 all.");
}

template <class V>
void members(V& v, Visited<V, Flow>& c) {
  v.type("Flow", "Lays the fur of the whole body along curves drawn on it, from the first point of each to the last.");
  place_members(v, c);
  v.curves(required("curves"), c.curves, {1, limits::flow_curves}, {2, limits::flow_points},
           "Curves on the model, each a list of points that fur follows from the first to the last.");
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.number(
      "reach", c.reach, width_in_units,
      "Farther away than this, in `units`, nothing changes; from half of it on the effect fades. Absent there is no "
      "end.");
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds,
         "How distances are measured. straight: through space. dijkstra: along edges, too long by some percent. heat: "
         "along the surface by the heat method, slower.");
  v.number("inclination", c.inclination, share,
           "How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given.");
  v.number("strength", c.strength, share, "How much it changes: 0 does nothing, 1 all.");
}

template <class V>
void members(V& v, Visited<V, Smooth>& c) {
  v.type("Smooth", "Blends each value with the mean of its neighbours, nearer ones counting more.");
  place_members(v, c), flood_member(v, c);
  v.number("t", c.t, share, "Share of the mean in each pass; up to 0.5 nothing oscillates.");
  v.integer("passes", c.passes, {1, limits::passes}, "How often the values are blended.");
  v.boolean("keep_inclination", c.keep_inclination,
            "Smooths headings alone, so that no tuft rises where opposite directions meet.");
  v.names("fields", c.fields, json_names::fields, 1, "field", "Fields that are smoothed.");
}

template <class V>
void members(V& v, Visited<V, Noise>& c) {
  v.type("Noise",
         "Adds random numbers that are a pure function of the seed and the place; inverted it takes them off.");
  place_members(v, c), flood_member(v, c);
  v.seed("seed", c.seed, "Other seeds give other noise.");
  v.number("amount", c.amount, {0, 10, "varies"},
           "How large the numbers are: for directions in inclinations; for length, stretch and width as a share of the "
           "value; for other fields in their own unit.");
  v.number("feature_size", c.feature_size, length_in_units,
           "Size of the noise's features, in `units`. At 0 every vertex moves for itself.");
  v.name("units", c.units, json_names::units);
  v.names("fields", c.fields, json_names::fields, 1, "field", "Fields that noise is added to.");
}

template <class V>
void members(V& v, Visited<V, Unify>& c) {
  v.type("Unify", "Blends to a value, or to the mean under the brush.");
  place_members(v, c), flood_member(v, c);
  v.direction("direction", c.direction, "Where fur is turned to.");
  v.number("inclination", c.inclination, share,
           "How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given.");
  v.number("length", c.length, length_in_units,
           "Length that fur tends to, in `units`; at most 10 sizes. The fur keeps its own unless given.");
  v.name("units", c.units, json_names::units);
  v.names("mean", c.mean, json_names::fields, 0, "field", "Fields that go to their weighted mean under the brush.");
  v.number("weight", c.weight, share, "How far values go, on top of the brush's own strength.");
}

template <class V>
void members(V& v, Visited<V, Part>& c) {
  v.type("Part", "A line that fur leans away from on both sides; inverted fur leans to it.");
  place_members(v, c);
  v.number("lean", c.lean, share, "Inclination that the fur tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Whorl>& c) {
  v.type("Whorl", "Turns fur round the nearest place of the stroke: a cowlick. Inverted it turns the other way.");
  place_members(v, c);
  v.number("turn_degrees", c.turn_degrees, {-180, 180, "degrees"},
           "Way that fur turns, counter-clockwise seen from outside: at 0 it points out, at 90 it circles, at 180 it "
           "points in.");
  v.number("lean", c.lean, share, "Inclination that the fur tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Length>& c) {
  v.type("Length", "Changes how long fur is.");
  place_members(v, c), flood_member(v, c);
  v.name("mode", c.mode, json_names::length_modes,
         "How `value` changes the length. average: to the mean under the brush. jitter: by a random share. min, max: "
         "not under, not over.");
  v.number(
      "value", c.value, coordinate.in("varies"),
      "A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a share "
      "for jitter, at most 1.");
  v.name("units", c.units, json_names::units);
  v.seed("seed", c.seed, "Other seeds give other random shares; for jitter.");
}

template <class V>
void members(V& v, Visited<V, TrimPlane>& c) {
  v.type("TrimPlane", "A plane; fur ends where it crosses it.");
  v.position(required("point"), c.point, "A point of the plane.");
  v.direction("normal", c.normal, "Direction to the side where no fur may be.");
}

template <class V>
void members(V& v, Visited<V, TrimSphere>& c) {
  v.type("TrimSphere", "A sphere; fur ends where it crosses it.");
  v.position(required("centre"), c.centre, "Centre of the sphere.");
  v.number("radius", c.radius, length_in_units, "Radius of the sphere, in `units`; at most 1000000 sizes.");
  v.boolean("keep_inside", c.keep_inside, "Fur ends where it leaves the sphere; else where it enters it.");
}

template <class V>
void members(V& v, Visited<V, Trim>& c) {
  v.type(
      "Trim",
      "Cuts fur by a plane, by a sphere or to a height over the skin, by the way that it leans. A flood cuts wholly, "
      "whatever the strength.");
  place_members(v, c), flood_member(v, c);
  v.template alternative<TrimPlane>("plane", c.shape, "Plane that fur is cut by.");
  v.template alternative<TrimSphere>("sphere", c.shape, "Sphere that fur is cut by.");
  v.alternative("height", c.shape, length_in_units,
                "Height over the skin that fur is cut to, in `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Lift>& c) {
  v.type("Lift", "Raises fur; inverted it lays it down. Fur that stands upright has no heading and stays.");
  place_members(v, c), flood_member(v, c);
}

template <class V>
void members(V& v, Visited<V, Erase>& c) {
  v.type("Erase",
         "Goes back to the first groom, or to a checkpoint or a revision of this scene; with a layer and neither of "
         "them, takes away what the layer adds. The mask stays unless it is named.");
  place_members(v, c), flood_member(v, c);
  v.text(sparse("checkpoint"), c.checkpoint,
         "Name of the checkpoint to go back to. Empty: the first groom, or `revision`.");
  v.counter("revision", c.revision, "Revision of this model to go back to.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "Fields that go back; all but the mask when empty.");
}

template <class V>
void members(V& v, Visited<V, Clump>& c) {
  v.type("Clump", "Turns fur to the line of the stroke and gathers its tips; inverted it opens them.");
  place_members(v, c);
  v.number("gather", c.gather, share, "How far fur turns.");
  v.number("amount", c.amount, share, "Value that the field clump tends to.");
}

template <class V>
void members(V& v, Visited<V, Curl>& c) {
  v.type("Curl", "Curls fur and turns its heading; inverted it takes the curl out.");
  place_members(v, c), flood_member(v, c);
  v.number("amount", c.amount, share, "Value that the field curl tends to.");
  v.number("turn_degrees", c.turn_degrees, {-180, 180, "degrees"},
           "How far the heading turns, counter-clockwise seen from outside.");
}

template <class V>
void members(V& v, Visited<V, Paint>& c) {
  v.type("Paint", "Paints a field; inverted it takes it back to its default.");
  place_members(v, c), flood_member(v, c);
  v.name("field", c.field, json_names::fields,
         "Field that is painted. Not direction, length or stretch, which have tools of their own.");
  v.number("value", c.value, {0, 4, "varies"},
           "Value that the field tends to: at most 1, for width and stiffness 4. For a colour how much of the coat's "
           "own it covers.");
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
  v.number("softness", c.softness, share, "Share of the radius over which it fades.");
}

template <class V>
void members(V& v, Visited<V, MaskPart>& c) {
  v.type("MaskPart", "The connected part of the model that is nearest.");
  v.position(required("position"), c.position, "A point near the part.");
}

template <class V>
void members(V& v, Visited<V, MaskMaterial>& c) {
  v.type("MaskMaterial", "All faces to which the model's file gives a material.");
  v.label(required("name"), c.name, "One of the scene's `materials`.");
}

template <class V>
void members(V& v, Visited<V, MaskPicture>& c) {
  v.type(
      "MaskPicture",
      "An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the file's "
      "own numbers, no curve undone.");
  v.picture(required("name"), c.name, "The name that the upload of a picture was answered with.");
  v.name("channel", c.channel, json_names::picture_channels, "Channel of the picture that is read.");
}

template <class V>
void members(V& v, Visited<V, ApplyMap>& c) {
  v.type("Map",
         "Puts a field in place of what a picture says at the vertices' texture coordinates, on seams the mean of what "
         "their islands say; or of what a list says of each vertex. The mask holds, unless it is the mask that is "
         "read. The commands of a batch read at most 8 "
         "different pictures.");
  v.picture(required("picture"), c.picture, "The name that the upload of a picture was answered with.");
  v.name("field", c.field, json_names::fields, "Field that is replaced.");
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units,
           "What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length.");
  v.name("units", c.units, json_names::units, "Unit of a scale of lengths. relative: sizes; world: the model's unit.");
  v.number("strength", c.strength, share, "How far the field goes to the picture's.");
  v.integer("tile", c.tile, {0, last_udim},
            "UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats, "
            "and all do.");
  layer_member(v, c);
}

template <class V>
void members(V& v, Visited<V, ChangeMask>& c) {
  v.type(
      "Mask",
      "Chooses where tools work: they change what the mask is 1 on, and nothing where it is 0. Brushes paint it with "
      "`paint`. Only select takes a shape, combine and value; only grow and shrink a distance; only smooth passes.");
  v.name(
      "action", c.action, json_names::mask_actions,
      "What is done with the mask: select chooses, grow and shrink move its edge, smooth softens it, invert swaps it.");
  if (v.takes(c.action == MaskAction::select)) {
    v.template alternative<MaskAll>("all", c.shape, "Everything. What select takes when no shape is given.");
    v.vertices("vertices", c.shape, "Numbers of the vertices that are chosen.");
    v.template alternative<MaskBox>("box", c.shape, "Chooses what lies in a box.");
    v.template alternative<MaskSphere>("sphere", c.shape, "Chooses what lies in a sphere.");
    v.template alternative<MaskPart>("part", c.shape);
    v.template alternative<MaskMaterial>("material", c.shape);
    v.template alternative<MaskPicture>("picture", c.shape);
    v.name("combine", c.combine, json_names::mask_combines,
           "How the shape joins the mask that is there. With replace the rest gets 1 - value.");
    v.number("value", c.value, share, "Mask value of what is chosen.");
  }
  if (v.takes(c.action == MaskAction::grow || c.action == MaskAction::shrink)) {
    v.number("distance", c.distance, length_in_units,
             "How far the edge moves along edges of the mesh, in `units`; at most 1000000 sizes.");
  }
  if (v.takes(c.action == MaskAction::smooth))
    v.integer("passes", c.passes, {1, limits::passes}, "How often the mask is smoothed.");
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Retarget>& c) {
  v.type(
      "Retarget",
      "Takes the fields of another scene, or of this one at another revision, from the nearest places of its surface. "
      "The mask holds.");
  v.label(required("scene"), c.scene, "Id of the source, on the same server.");
  v.counter("revision", c.revision, "Revision of the source's model; the present one unless given.");
  v.name(
      "align", c.align, json_names::alignments,
      "How the models are laid over each other. box: their boxes lie over each other, axis by axis, and lengths stay "
      "shares of the size. none: both have the same coordinates, and lengths stay what they are in the model's unit.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "Fields that are taken; all but the mask when empty.");
  v.number("strength", c.strength, share, "How much it changes: 0 does nothing, 1 all.");
  layer_member(v, c);
}

}  // namespace pelage::json_parts
