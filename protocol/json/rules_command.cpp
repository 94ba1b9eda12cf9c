// Rules between the members of commands.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "protocol/json/rules.h"

namespace pelage::json_parts {

namespace {

/// Refuses a tool that can flood, unless it has either a stroke or a flood.
template <class Tool>
void check_reach(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.flood; }) {
    if (tool.flood == tool.stroke.has_value())
      value.refuse_below("stroke", "The tool takes a stroke, or \"flood\": true.", "one of stroke | flood");
  }
}

bool needs_view(const Brush& brush) {
  return brush.units == RadiusUnits::pixels || brush.falloff_shape == FalloffShape::screen;
}

template <class Tool>
void check_view(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.brush; }) {
    if (tool.stroke && !tool.stroke->view && needs_view(tool.brush))
      value.refuse_below("stroke/view", "A radius in pixels and the screen shape need a view.", "required");
  }
}

bool is_colour(Field field) { return shape_of(field).channels == 4; }
bool are_colours(const std::vector<Field>& fields) {
  return !fields.empty() && std::all_of(fields.begin(), fields.end(), is_colour);
}

/// Returns whether the tool changes colours only; no other field differs from root to tip.
template <class Tool>
bool changes_colours_only(const Tool& tool) {
  if constexpr (requires { tool.field; }) return is_colour(tool.field);
  if constexpr (requires { tool.fields; }) return are_colours(tool.fields);
  return false;
}
bool changes_colours_only(const Unify& unify) {
  return are_colours(unify.mean) && !unify.direction && !unify.inclination && !unify.length;
}

bool names_mask(Field field) { return field == Field::mask; }
bool names_mask(const std::vector<Field>& fields) { return std::count(fields.begin(), fields.end(), Field::mask) > 0; }

/// Refuses an edit layer if the mask is changed, which belongs to no edit layer.
template <class Tool>
void check_layer(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.edit_layer; }) {
    bool mask = false;
    if constexpr (requires { tool.field; }) mask = mask || names_mask(tool.field);
    if constexpr (requires { tool.fields; }) mask = mask || names_mask(tool.fields);
    if constexpr (requires { tool.mean; }) mask = mask || names_mask(tool.mean);
    if (mask && !tool.edit_layer.empty())
      value.refuse_below("edit_layer", "The mask belongs to no edit layer.", "no edit layer for the mask");
  }
}

/// Refuses a list of coats with duplicates or too many names.
template <class Tool>
void check_coats(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.edit_layer; }) {
    const std::set<std::string> names(tool.coats.begin(), tool.coats.end());
    if (tool.coats.size() > limits::coats || names.size() != tool.coats.size())
      value.refuse_below("coats", "Each coat is named once.", "at most " + std::to_string(limits::coats) + " names");
  }
}

template <class Tool>
void check_brush(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.brush; }) {
    const Brush& brush = tool.brush;
    if (brush.invert && Tool::opposite == Opposite::no)
      value.refuse_below("brush/invert", "The tool has no opposite.", "false");
    if (brush.reach == Reach::fur && brush.falloff_shape != FalloffShape::volume)
      value.refuse_below("brush/reach", "The distance to strands is measured through space.",
                         "skin, or falloff_shape volume");
    if (brush.strand_to <= brush.strand_from)
      value.refuse_below("brush/strand_to", "The part of the strand ends before it begins.", "above strand_from");
    if ((brush.strand_from > 0 || brush.strand_to < 1) && !changes_colours_only(tool)) {
      value.refuse_below("brush/strand_from", "Only colours differ from root to tip.",
                         "0 to 1, or a tool that changes nothing but root_colour and tip_colour");
    }
  }
}

void check(const Value& value, const Comb& comb) {
  if (comb.flood != comb.direction.has_value()) {
    value.refuse_below("direction", "A flooding comb needs a direction, and a stroke brings its own.",
                       "with flood only");
  }
}

void check(const Value& value, const Blow& blow) {
  const bool own = value.tree().contains("source");
  if (blow.blower.empty() != own)
    value.refuse_below("source", "Wind has a source, or the name of a blower.", "one of source | blower");
}

void check(const Value& value, const Attract& attract) {
  const bool own = value.tree().contains("point");
  if (attract.attractor.empty() != own)
    value.refuse_below("point", "A stick has a point, or the name of an attractor.", "one of point | attractor");
}

void check(const Value& value, const Interpolate& command) {
  for (std::size_t k = 0; k < command.keys.size(); ++k) {
    const Key& key = command.keys[k];
    const std::string pointer = "keys/" + std::to_string(k);
    if (!key.direction && !key.length)
      value.refuse_below(pointer, "A key gives a direction or a length.", "direction | length");
    if (!key.direction && key.inclination)
      value.refuse_below(pointer + "/inclination", "An inclination comes with a direction.", "with direction only");
  }
}

void check(const Value& value, const Unify& unify) {
  if (!unify.direction && !unify.inclination && !unify.length && unify.mean.empty())
    value.refuse("The command names nothing to unify.", "one or more of direction | inclination | length | mean");
  const auto has = [&](Field field) { return std::count(unify.mean.begin(), unify.mean.end(), field) > 0; };
  if ((has(Field::direction) && (unify.direction || unify.inclination)) || (has(Field::length) && unify.length))
    value.refuse_below("mean", "A field goes to its mean or to a value.", "fields without a value");
}

void check(const Value& value, const Length& length) {
  const bool jitter = length.mode == LengthMode::jitter;
  if (length.mode != LengthMode::add && length.value < 0)
    value.refuse_below("value", "Only add takes a value below 0.", "at least 0");
  if (jitter && length.value > 1) value.refuse_below("value", "A jitter is a share of the length.", "[0, 1]");
}

void check(const Value& value, const Trim&) {
  const auto& tree = value.tree();
  if (!tree.contains("plane") && !tree.contains("sphere") && !tree.contains("height"))
    value.refuse("Nothing says where fur ends.", "one of plane | sphere | height");
}

void check(const Value& value, const Erase& erase) {
  if (!erase.checkpoint.empty() && erase.revision)
    value.refuse_below("revision", "A checkpoint and a revision exclude each other.", "one of checkpoint | revision");
}

void check(const Value& value, const Paint& paint) {
  const FieldShape& shape = shape_of(paint.field);
  const Field unpaintable[] = {Field::direction, Field::length, Field::stretch};
  if (std::count(std::begin(unpaintable), std::end(unpaintable), paint.field) > 0)
    value.refuse_below("field", "Other tools change this field.",
                       "density | width | curl | clump | wetness | bare | mask | root_colour | tip_colour | stiffness");
  if (paint.value > shape.max) value.refuse_below("value", "The value is beyond the field's range.", "[0, 1]");
}

void check(const Value& value, const ChangeMask& mask) {
  if (const auto* box = std::get_if<MaskBox>(&mask.shape); box && glm::any(glm::greaterThan(box->min, box->max)))
    value.refuse_below("box/max", "The box ends before it begins.", "at least min");
}

void check(const Value& value, const ApplyMap& map) {
  refuse_encoding(value, map.field, map.encoding);
  refuse_tile(value, map.tile, map.encoding);
}

template <class T>
void check_names(const Value& value, const char* list, const std::vector<T>& named) {
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto twin = std::find_if(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(k),
                                   [&](const T& other) { return other.name == named[k].name; });
    if (twin != named.begin() + static_cast<std::ptrdiff_t>(k))
      value.refuse_below(std::string(list) + "/" + std::to_string(k) + "/name", "The name is taken.", "each name once");
  }
}

void check(const Value& value, const SetBlowers& c) { check_names(value, "blowers", c.blowers); }
void check(const Value& value, const SetAttractors& c) { check_names(value, "attractors", c.attractors); }

void check(const Value& value, const SetCoats& command) {
  check_names(value, "coats", command.coats);
  std::set<std::uint64_t> ids;
  for (std::size_t k = 0; k < command.coats.size(); ++k) {
    const std::optional<std::uint64_t>& id = command.coats[k].id;
    if (!id || (*id < limits::coats && ids.insert(*id).second)) continue;
    value.refuse_below("coats/" + std::to_string(k) + "/id", "A coat has a number of its own.",
                       "[0, " + std::to_string(limits::coats - 1) + "], each once");
  }
  if (std::ranges::all_of(command.coats, &CoatEntry::muted))
    value.refuse_below("coats", "One coat at least is seen.", "one that is not muted");
}

void check(const Value& value, const SetCurves& command) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < command.groups.size(); ++k) {
    count += curve_count(command.groups[k]);
    if (count > limits::curves)
      value.refuse_below("groups/" + std::to_string(k), "These are too many curves.",
                         "at most " + std::to_string(limits::curves) + " in all groups");
  }
}

void check(const Value& value, const ChangeEditLayer& layer) {
  if (layer.action == EditLayerAction::set && !layer.weight && !layer.muted && layer.rename.empty())
    value.refuse("The command sets nothing of the edit layer.", "one or more of weight | muted | rename");
  if (layer.action == EditLayerAction::move && !layer.above)
    value.refuse_below("above", "The command does not say where the edit layer moves to.", "required");
  if (layer.above == layer.name) value.refuse_below("above", "An edit layer cannot lie on itself.", "another layer");
}

}  // namespace

void check_command(const Value& value, const Command& command) {
  std::visit(
      [&](const auto& tool) {
        check_reach(value, tool);
        check_view(value, tool);
        check_brush(value, tool);
        check_layer(value, tool);
        check_coats(value, tool);
        check(value, tool);
      },
      command);
}

}  // namespace pelage::json_parts
