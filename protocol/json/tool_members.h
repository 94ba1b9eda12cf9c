// The members of each tool on the wire, once: decoding, encoding and the tests' random commands visit the same list.
#pragma once

#include <type_traits>

#include "protocol/base/limits.h"
#include "protocol/commands/command.h"
#include "protocol/json/names.h"
#include "protocol/json/ranges.h"

namespace pelage::json_parts {

/// A tool that a visitor fills, or reads.
template <class Visitor, class Tool>
using Visited = std::conditional_t<Visitor::reads, const Tool, Tool>;

/// Where a tool works, and which layer keeps what it changes.
template <class V, class Tool>
void place_members(V& v, Tool& c) {
  v.stroke(c.stroke), v.brush(c.brush), v.text("layer", c.layer);
}

template <class V>
void members(V& v, Visited<V, Comb>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.number("lean", c.lean, share);
  v.boolean("keep_inclination", c.keep_inclination);
  v.direction("direction", c.direction);
}

template <class V>
void wind_members(V& v, Visited<V, Blow>& c) {
  v.position("source", c.source);
  v.direction("direction", c.direction);
  v.number("cone_degrees", c.cone_degrees, half_circle);
  v.number("softness", c.softness, share);
  v.number("fall", c.fall, length_in_units);
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share);
  v.number("lean", c.lean, share);
}

template <class V>
void members(V& v, Visited<V, Blow>& c) {
  place_members(v, c);
  v.text("blower", c.blower);
  if (c.blower.empty()) wind_members(v, c);
}

template <class V>
void stick_members(V& v, Visited<V, Attract>& c) {
  v.position("point", c.point);
  v.number("radius", c.radius, length_in_units);
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share);
  v.number("duration", c.duration, {0, 1e4});
  v.number("threshold", c.threshold, {0, 1e3});
  v.number("max_stretch", c.max_stretch, {1, 100});
}

template <class V>
void members(V& v, Visited<V, Attract>& c) {
  place_members(v, c);
  v.text("attractor", c.attractor);
  if (c.attractor.empty()) stick_members(v, c);
}

template <class V>
void members(V& v, Visited<V, Key>& key) {
  v.required_position("position", key.position);
  v.direction("direction", key.direction);
  v.number("inclination", key.inclination, share);
  v.number("length", key.length, length_in_units);
}

template <class V>
void members(V& v, Visited<V, Interpolate>& c) {
  place_members(v, c);
  v.objects("keys", c.keys, {1, limits::keys});
  v.number("sigma", c.sigma, width_in_units);
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds);
  v.number("strength", c.strength, share);
}

template <class V>
void members(V& v, Visited<V, Flow>& c) {
  place_members(v, c);
  v.curves("curves", c.curves, {1, limits::flow_curves}, {2, limits::flow_points});
  v.number("sigma", c.sigma, width_in_units);
  v.name("units", c.units, json_names::units);
  v.name("distance", c.distance, json_names::distance_kinds);
  v.number("inclination", c.inclination, share);
  v.number("strength", c.strength, share);
}

template <class V>
void members(V& v, Visited<V, Smooth>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.number("t", c.t, share);
  v.integer("passes", c.passes, {1, limits::passes});
  v.boolean("keep_inclination", c.keep_inclination);
  v.fields("fields", c.fields, 1);
}

template <class V>
void members(V& v, Visited<V, Noise>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.seed("seed", c.seed);
  v.number("amount", c.amount, {0, 10});
  v.number("feature_size", c.feature_size, length_in_units);
  v.name("units", c.units, json_names::units);
  v.fields("fields", c.fields, 1);
}

template <class V>
void members(V& v, Visited<V, Unify>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.direction("direction", c.direction);
  v.number("inclination", c.inclination, share);
  v.number("length", c.length, length_in_units);
  v.name("units", c.units, json_names::units);
  v.fields("mean", c.mean, 0);
  v.number("weight", c.weight, share);
}

template <class V>
void members(V& v, Visited<V, Part>& c) {
  place_members(v, c);
  v.number("lean", c.lean, share);
}

template <class V>
void members(V& v, Visited<V, Length>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.name("mode", c.mode, json_names::length_modes);
  v.number("value", c.value, {-length_in_units.high, length_in_units.high});
  v.name("units", c.units, json_names::units);
  v.seed("seed", c.seed);
}

template <class V>
void members(V& v, Visited<V, TrimPlane>& plane) {
  v.required_position("point", plane.point);
  v.direction("normal", plane.normal);
}

template <class V>
void members(V& v, Visited<V, TrimSphere>& sphere) {
  v.required_position("centre", sphere.centre);
  v.number("radius", sphere.radius, length_in_units);
  v.boolean("keep_inside", sphere.keep_inside);
}

template <class V>
void members(V& v, Visited<V, Trim>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.template alternative<TrimPlane>("plane", c.shape);
  v.template alternative<TrimSphere>("sphere", c.shape);
  v.alternative("height", c.shape, length_in_units);
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, Lift>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
}

template <class V>
void members(V& v, Visited<V, Erase>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.text("checkpoint", c.checkpoint);
  v.counter("revision", c.revision);
  v.fields("fields", c.fields, 0);
}

template <class V>
void members(V& v, Visited<V, Clump>& c) {
  place_members(v, c);
  v.number("gather", c.gather, share);
  v.number("amount", c.amount, share);
}

template <class V>
void members(V& v, Visited<V, Curl>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.number("amount", c.amount, share);
  v.number("turn_degrees", c.turn_degrees, {-180, 180});
}

template <class V>
void members(V& v, Visited<V, Paint>& c) {
  place_members(v, c), v.boolean("flood", c.flood);
  v.field("field", c.field);
  v.number("value", c.value, {0, 4});
  if (shape_of(c.field).channels == 4) v.colour("colour", c.colour);
}

template <class V>
void members(V&, Visited<V, MaskAll>&) {}

template <class V>
void members(V& v, Visited<V, MaskBox>& box) {
  v.required_position("min", box.min);
  v.required_position("max", box.max);
}

template <class V>
void members(V& v, Visited<V, MaskSphere>& sphere) {
  v.required_position("centre", sphere.centre);
  v.number("radius", sphere.radius, length_in_units);
  v.number("softness", sphere.softness, share);
}

template <class V>
void members(V& v, Visited<V, MaskPart>& part) {
  v.required_position("position", part.position);
}

template <class V>
void members(V& v, Visited<V, MaskPicture>& picture) {
  v.picture("name", picture.name);
  v.name("channel", picture.channel, json_names::picture_channels);
}

template <class V>
void members(V& v, Visited<V, ApplyMap>& c) {
  v.picture("picture", c.picture);
  v.field("field", c.field);
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, map_scale);
  v.name("units", c.units, json_names::units);
  v.number("strength", c.strength, share);
  v.text("layer", c.layer);
}

template <class V>
void members(V& v, Visited<V, ChangeMask>& c) {
  v.name("action", c.action, json_names::mask_actions);
  if (c.action == MaskAction::select) {
    v.template alternative<MaskAll>("all", c.shape);
    v.vertices("vertices", c.shape);
    v.template alternative<MaskBox>("box", c.shape);
    v.template alternative<MaskSphere>("sphere", c.shape);
    v.template alternative<MaskPart>("part", c.shape);
    v.template alternative<MaskPicture>("picture", c.shape);
    v.name("combine", c.combine, json_names::mask_combines);
    v.number("value", c.value, share);
  }
  if (c.action == MaskAction::grow || c.action == MaskAction::shrink)
    v.number("distance", c.distance, length_in_units);
  if (c.action == MaskAction::smooth) v.integer("passes", c.passes, {1, limits::passes});
  v.name("units", c.units, json_names::units);
}

template <class V>
void members(V& v, Visited<V, NamedBlower>& named) {
  v.required_text("name", named.name);
  wind_members(v, named.blow);
}

template <class V>
void members(V& v, Visited<V, NamedAttractor>& named) {
  v.required_text("name", named.name);
  stick_members(v, named.attract);
}

template <class V>
void members(V& v, Visited<V, SetBlowers>& c) {
  v.objects("blowers", c.blowers, {0, limits::blowers});
}

template <class V>
void members(V& v, Visited<V, SetAttractors>& c) {
  v.objects("attractors", c.attractors, {0, limits::blowers});
}

template <class V>
void members(V& v, Visited<V, Plane>& plane) {
  v.position("point", plane.point);
  v.direction("normal", plane.normal);
}

template <class V>
void members(V& v, Visited<V, Symmetry>& symmetry) {
  v.objects("planes", symmetry.planes, {0, limits::symmetry_planes});
  v.position("axis_point", symmetry.axis_point);
  v.direction("axis", symmetry.axis);
  v.integer("count", symmetry.count, {1, limits::symmetry_images});
}

template <class V>
void members(V& v, Visited<V, SetSymmetry>& c) {
  v.object("symmetry", c.symmetry);
}

template <class V>
void members(V& v, Visited<V, Checkpoint>& c) {
  v.required_text("name", c.name);
  v.counter("revision", c.revision);
}

template <class V>
void members(V& v, Visited<V, ChangeLayer>& c) {
  v.name("action", c.action, json_names::layer_actions);
  v.required_text("name", c.name);
  const bool add = c.action == LayerAction::add, set = c.action == LayerAction::set;
  if (add || set) v.number("weight", c.weight, layer_weight), v.boolean("muted", c.muted);
  if (set) v.text("rename", c.rename);
  if (add || c.action == LayerAction::move) v.text("above", c.above);
}

template <class V>
void members(V& v, Visited<V, Retarget>& c) {
  v.required_text("scene", c.scene);
  v.counter("revision", c.revision);
  v.name("align", c.align, json_names::alignments);
  v.fields("fields", c.fields, 0);
  v.number("strength", c.strength, share);
  v.text("layer", c.layer);
}

/// Whether the tool's members are listed here.
template <class Tool>
concept ListedTool =
    std::is_same_v<Tool, Comb> || std::is_same_v<Tool, Blow> || std::is_same_v<Tool, Attract> ||
    std::is_same_v<Tool, Interpolate> || std::is_same_v<Tool, Flow> || std::is_same_v<Tool, Smooth> ||
    std::is_same_v<Tool, Noise> || std::is_same_v<Tool, Unify> || std::is_same_v<Tool, Part> ||
    std::is_same_v<Tool, Length> || std::is_same_v<Tool, Trim> || std::is_same_v<Tool, Lift> ||
    std::is_same_v<Tool, Erase> || std::is_same_v<Tool, Clump> || std::is_same_v<Tool, Curl> ||
    std::is_same_v<Tool, Paint> || std::is_same_v<Tool, ChangeMask> || std::is_same_v<Tool, SetBlowers> ||
    std::is_same_v<Tool, SetAttractors> || std::is_same_v<Tool, SetSymmetry> || std::is_same_v<Tool, Checkpoint> ||
    std::is_same_v<Tool, ChangeLayer> || std::is_same_v<Tool, Retarget> || std::is_same_v<Tool, ApplyMap>;

}  // namespace pelage::json_parts
