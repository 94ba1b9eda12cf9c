// Commands on the wire.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/json/members_stroke.h"

namespace pelage::json_parts {

/// The edit layer that keeps what a tool changes.
template <class V, class Tool>
void layer_member(V& v, Tool& c) {
  v.text(sparse("edit_layer"), c.edit_layer,
         "Edit layer that keeps what changes; the groom below all edit layers unless named.");
}

/// Where a tool works.
template <class V, class Tool>
void place_members(V& v, Tool& c) {
  v.object(NeedsStroke<Tool> ? required("stroke") : "stroke", c.stroke);
  v.object("brush", c.brush);
  layer_member(v, c);
}

template <class V, class Tool>
void flood_member(V& v, Tool& c) {
  v.boolean("flood", c.flood, "Everywhere in place of a stroke.");
}

template <class V>
void members(V& v, Visited<V, Comb>& c) {
  v.type("Comb", "Turns fur the way the stroke moves; as a flood, to `direction` everywhere.");
  place_members(v, c), flood_member(v, c);
  v.number("lean", c.lean, share, "Inclination that combing tends to: 0 upright, 1 lying.");
  v.boolean("keep_inclination", c.keep_inclination, "Turn the heading alone.");
  v.direction("direction", c.direction);
}

template <class V>
void wind_members(V& v, Visited<V, Blow>& c, MemberName source) {
  v.position(source, c.source);
  v.direction("direction", c.direction);
  v.number("cone_degrees", c.cone_degrees, half_circle, "Half angle of the cone, degrees.");
  v.number("softness", c.softness, share, "Share of the cone over which its edge fades.");
  v.number("fall", c.fall, length_in_units,
           "Distance at which the wind has half its strength, in `units`; 0: it does not fall.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
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
  v.position(point, c.point);
  v.number("radius", c.radius, length_in_units, "In `units`; at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
  v.number("duration", c.duration, {0, 10000}, "Seconds of pulling.");
  v.number("threshold", c.threshold, {0, 1000}, "Stretch that fur takes without growing.");
  v.number("max_stretch", c.max_stretch, {1, 100}, "Largest length over the length before any stretch.");
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
  v.position(required("position"), c.position, "The nearest place on the surface is meant.");
  v.direction("direction", c.direction);
  v.number("inclination", c.inclination, share, "0.5 unless given, where there is a direction.");
  v.number("length", c.length, length_in_units, "In `units`; at most 10 sizes.");
}

template <class V>
void members(V& v, Visited<V, Interpolate>& c) {
  v.type("Interpolate",
         "Spreads keys over the surface with Gaussian weights of the distance. What no key reaches keeps its value.");
  place_members(v, c);
  v.objects(required("keys"), c.keys, {1, limits::keys});
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
  v.name(
      "distance", c.distance, json_names::distance_kinds,
      "straight: through space. dijkstra: along edges, too long by some percent. heat: along the surface by the heat "
      "method, slower.");
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
}

template <class V>
void members(V& v, Visited<V, Flow>& c) {
  v.type("Flow", "Lays the fur of the whole body along curves drawn on it, from the first point of each to the last.");
  place_members(v, c);
  v.curves(required("curves"), c.curves, {1, limits::flow_curves}, {2, limits::flow_points});
  v.number("sigma", c.sigma, width_in_units,
           "Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes.");
  v.name("units", c.units, json_names::units);
  v.name(
      "distance", c.distance, json_names::distance_kinds,
      "straight: through space. dijkstra: along edges, too long by some percent. heat: along the surface by the heat "
      "method, slower.");
  v.number("inclination", c.inclination, share, "The fur keeps its own unless given.");
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
}

template <class V>
void members(V& v, Visited<V, Smooth>& c) {
  v.type("Smooth", "Blends each value with the mean of its neighbours, nearer ones counting more.");
  place_members(v, c), flood_member(v, c);
  v.number("t", c.t, share, "Share of the mean in each pass; up to 0.5 nothing oscillates.");
  v.integer("passes", c.passes, {1, limits::passes});
  v.boolean("keep_inclination", c.keep_inclination,
            "Smooth headings alone, so that no tuft rises where opposite directions meet.");
  v.names("fields", c.fields, json_names::fields, 1, "field");
}

template <class V>
void members(V& v, Visited<V, Noise>& c) {
  v.type("Noise",
         "Adds random numbers that are a pure function of the seed and the place; inverted it takes them off.");
  place_members(v, c), flood_member(v, c);
  v.seed("seed", c.seed);
  v.number("amount", c.amount, {0, 10},
           "Of directions in inclinations; of length, stretch and width a share of the value; of other fields added.");
  v.number("feature_size", c.feature_size, length_in_units, "Of the noise, in `units`; 0: every vertex for itself.");
  v.name("units", c.units, json_names::units);
  v.names("fields", c.fields, json_names::fields, 1, "field");
}

template <class V>
void members(V& v, Visited<V, Unify>& c) {
  v.type("Unify", "Blends to a value, or to the mean under the brush.");
  place_members(v, c), flood_member(v, c);
  v.direction("direction", c.direction);
  v.number("inclination", c.inclination, share, "The fur keeps its own unless given.");
  v.number("length", c.length, length_in_units, "In `units`; at most 10 sizes.");
  v.name("units", c.units, json_names::units);
  v.names("mean", c.mean, json_names::fields, 0, "field", "Fields that go to their weighted mean.");
  v.number("weight", c.weight, share, "Beside the brush's own strength.");
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
  v.number("turn_degrees", c.turn_degrees, {-180, 180},
           "From outwards, counter-clockwise seen from outside: 0 points out, 90 circles, 180 points in.");
  v.number("lean", c.lean, share, "Inclination that the fur tends to: 0 upright, 1 lying.");
}

template <class V>
void members(V& v, Visited<V, Length>& c) {
  v.type("Length", "Changes how long fur is.");
  place_members(v, c), flood_member(v, c);
  v.name("mode", c.mode, json_names::length_modes,
         "average: to the mean under the brush. jitter: by a random share. min, max: not under, not over.");
  v.number(
      "value", c.value, coordinate,
      "A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a share "
      "for jitter, at most 1.");
  v.name("units", c.units, json_names::units);
  v.seed("seed", c.seed);
}

template <class V>
void members(V& v, Visited<V, TrimPlane>& c) {
  v.type("TrimPlane");
  v.position(required("point"), c.point);
  v.direction("normal", c.normal, "To the side where no fur may be.");
}

template <class V>
void members(V& v, Visited<V, TrimSphere>& c) {
  v.type("TrimSphere");
  v.position(required("centre"), c.centre);
  v.number("radius", c.radius, length_in_units, "In `units`; at most 1000000 sizes.");
  v.boolean("keep_inside", c.keep_inside, "Fur ends where it leaves the sphere; else where it enters it.");
}

template <class V>
void members(V& v, Visited<V, Trim>& c) {
  v.type(
      "Trim",
      "Cuts fur by a plane, by a sphere or to a height over the skin, by the way that it leans. A flood cuts wholly, "
      "whatever the strength.");
  place_members(v, c), flood_member(v, c);
  v.template alternative<TrimPlane>("plane", c.shape);
  v.template alternative<TrimSphere>("sphere", c.shape);
  v.alternative("height", c.shape, length_in_units, "In `units`; at most 1000000 sizes.");
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
  v.text(sparse("checkpoint"), c.checkpoint);
  v.counter("revision", c.revision, "Of this model.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "All but the mask when empty.");
}

template <class V>
void members(V& v, Visited<V, Clump>& c) {
  v.type("Clump", "Turns fur to the line of the stroke and gathers its tips; inverted it opens them.");
  place_members(v, c);
  v.number("gather", c.gather, share, "How far fur turns.");
  v.number("amount", c.amount, share, "What the field clump tends to.");
}

template <class V>
void members(V& v, Visited<V, Curl>& c) {
  v.type("Curl", "Curls fur and turns its heading; inverted it takes the curl out.");
  place_members(v, c), flood_member(v, c);
  v.number("amount", c.amount, share, "What the field curl tends to.");
  v.number("turn_degrees", c.turn_degrees, {-180, 180}, "Counter-clockwise seen from outside.");
}

template <class V>
void members(V& v, Visited<V, Paint>& c) {
  v.type("Paint", "Paints a field; inverted it takes it back to its default.");
  place_members(v, c), flood_member(v, c);
  v.name("field", c.field, json_names::fields, "Not direction, length or stretch, which have tools of their own.");
  v.number("value", c.value, {0, 4}, "At most 1, of width 4. Of a colour how much it covers.");
  if (v.takes(shape_of(c.field).channels == 4)) v.colour("colour", c.colour, "Of root_colour and tip_colour only.");
}

template <class V>
void members(V& v, Visited<V, MaskAll>&) {
  v.type("MaskAll");
}

template <class V>
void members(V& v, Visited<V, MaskBox>& c) {
  v.type("MaskBox");
  v.position(required("min"), c.min);
  v.position(required("max"), c.max);
}

template <class V>
void members(V& v, Visited<V, MaskSphere>& c) {
  v.type("MaskSphere");
  v.position(required("centre"), c.centre);
  v.number("radius", c.radius, length_in_units, "In `units`; at most 1000000 sizes.");
  v.number("softness", c.softness, share, "Share of the radius over which it fades.");
}

template <class V>
void members(V& v, Visited<V, MaskPart>& c) {
  v.type("MaskPart", "The connected part of the model that is nearest.");
  v.position(required("position"), c.position);
}

template <class V>
void members(V& v, Visited<V, MaskPicture>& c) {
  v.type(
      "MaskPicture",
      "An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the file's "
      "own numbers, no curve undone.");
  v.picture(required("name"), c.name, "The name that the upload of a picture was answered with.");
  v.name("channel", c.channel, json_names::picture_channels);
}

template <class V>
void members(V& v, Visited<V, ApplyMap>& c) {
  v.type("Map",
         "Puts a field in place of what a picture says at the vertices' texture coordinates, on seams the mean of what "
         "their islands say; or of what a list says of each vertex. The mask holds, unless it is the mask that is "
         "read. The commands of a batch read at most 8 "
         "different pictures.");
  v.picture(required("picture"), c.picture, "The name that the upload of a picture was answered with.");
  v.name("field", c.field, json_names::fields);
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units,
           "What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length.");
  v.name("units", c.units, json_names::units, "Of a scale of lengths. relative: sizes; world: the model's unit.");
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
  v.name("action", c.action, json_names::mask_actions);
  if (v.takes(c.action == MaskAction::select)) {
    v.template alternative<MaskAll>("all", c.shape, "Everything. What select takes when no shape is given.");
    v.vertices("vertices", c.shape);
    v.template alternative<MaskBox>("box", c.shape);
    v.template alternative<MaskSphere>("sphere", c.shape);
    v.template alternative<MaskPart>("part", c.shape);
    v.template alternative<MaskPicture>("picture", c.shape);
    v.name("combine", c.combine, json_names::mask_combines,
           "With what the mask is. With replace the rest gets 1 - value.");
    v.number("value", c.value, share, "What the chosen get.");
  }
  if (v.takes(c.action == MaskAction::grow || c.action == MaskAction::shrink)) {
    v.number("distance", c.distance, length_in_units, "Along edges, in `units`; at most 1000000 sizes.");
  }
  if (v.takes(c.action == MaskAction::smooth)) v.integer("passes", c.passes, {1, limits::passes});
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Retarget>& c) {
  v.type(
      "Retarget",
      "Takes the fields of another scene, or of this one at another revision, from the nearest places of its surface. "
      "The mask holds.");
  v.label(required("scene"), c.scene, "Id of the source, on the same server.");
  v.counter("revision", c.revision, "Of the source's model; the present one unless given.");
  v.name(
      "align", c.align, json_names::alignments,
      "box: the models' boxes lie over each other, axis by axis, and lengths stay shares of the size; none: both have "
      "the same coordinates, and lengths stay what they are in the model's unit.");
  v.names("fields", c.fields, json_names::fields, 0, "field", "All but the mask when empty.");
  v.number("strength", c.strength, share);
  layer_member(v, c);
}

}  // namespace pelage::json_parts
