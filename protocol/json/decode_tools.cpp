#include "protocol/json/decode_tools.h"

#include <algorithm>

#include "protocol/json/decode_parts.h"
#include "protocol/json/tool_members.h"

namespace pelage::json_parts {

namespace {

/// Fills a tool from the members of an object.
class MemberReader {
 public:
  static constexpr bool reads = false;  // the tool is written to
  explicit MemberReader(Object& object) : object_(object) {}

  void stroke(std::optional<Stroke>& out) {
    object_.optional("stroke", [&](const Value& v) { out = json_parts::stroke(v); });
  }
  void brush(Brush& out) {
    object_.optional("brush", [&](const Value& v) { out = json_parts::brush(v); });
  }
  void boolean(std::string_view name, bool& out) { object_.boolean(name, out); }
  void boolean(std::string_view name, std::optional<bool>& out) {
    object_.optional(name, [&](const Value& v) { out = v.boolean(); });
  }
  void number(std::string_view name, double& out, Range range) { object_.number(name, out, range); }
  void number(std::string_view name, std::optional<double>& out, Range range) {
    object_.optional(name, [&](const Value& v) { out = v.number(range); });
  }
  void integer(std::string_view name, int& out, Range range) { object_.integer(name, out, range); }
  void seed(std::string_view name, std::uint32_t& out) { object_.integer(name, out); }
  void counter(std::string_view name, std::optional<std::uint64_t>& out) {
    object_.optional(name, [&](const Value& v) { out = v.counter(); });
  }
  void text(std::string_view name, std::string& out) {
    object_.optional(name, [&](const Value& v) { out = v.text(0, limits::name_bytes); });
  }
  void text(std::string_view name, std::optional<std::string>& out) {
    object_.optional(name, [&](const Value& v) { out = v.text(0, limits::name_bytes); });
  }
  void required_text(std::string_view name, std::string& out) {
    object_.required(name, [&](const Value& v) { out = v.text(1, limits::name_bytes); });
  }
  void picture(std::string_view name, std::string& out) {
    object_.required(name, [&](const Value& v) { out = json_parts::picture_name(v); });
  }
  void position(std::string_view name, glm::dvec3& out) { object_.triple(name, out, coordinate); }
  void required_position(std::string_view name, glm::dvec3& out) {
    object_.required(name, [&](const Value& v) { out = v.triple(coordinate); });
  }
  void direction(std::string_view name, glm::dvec3& out) {
    object_.optional(name, [&](const Value& v) { out = v.direction(); });
  }
  void direction(std::string_view name, std::optional<glm::dvec3>& out) {
    object_.optional(name, [&](const Value& v) { out = v.direction(); });
  }
  void colour(std::string_view name, glm::vec3& out) { object_.colour(name, out); }
  template <class E, std::size_t N>
  void name(std::string_view name, E& out, const std::array<json_names::Name<E>, N>& names) {
    object_.name(name, out, names);
  }
  void field(std::string_view name, Field& out) { object_.name(name, out, json_names::fields); }
  void fields(std::string_view name, std::vector<Field>& out, std::size_t least) {
    object_.optional(name, [&](const Value& list) {
      out.clear();
      for (const Value& member : list.list(least, field_count)) {
        const Field field = member.name_of(json_names::fields);
        if (std::count(out.begin(), out.end(), field) > 0) member.refuse("The field is named twice.", "each field once");
        out.push_back(field);
      }
    });
  }
  template <class T>
  void object(std::string_view name, T& out) {
    object_.required(name, [&](const Value& value) { out = read<T>(value); });
  }
  template <class T>
  void objects(std::string_view name, std::vector<T>& out, Count count) {
    object_.required(name, [&](const Value& list) {
      for (const Value& member : list.list(count.least, count.most)) out.push_back(read<T>(member));
    });
  }
  void curves(std::string_view name, std::vector<std::vector<glm::dvec3>>& out, Count count, Count points) {
    object_.required(name, [&](const Value& list) {
      for (const Value& member : list.list(count.least, count.most)) {
        std::vector<glm::dvec3>& curve = out.emplace_back();
        for (const Value& point : member.list(points.least, points.most)) curve.push_back(point.triple(coordinate));
      }
    });
  }
  template <class T, class Variant>
  void alternative(std::string_view name, Variant& out) {
    object_.optional(name, [&](const Value& value) { out = read<T>(value), count_alternative(value); });
  }
  template <class Variant>
  void alternative(std::string_view name, Variant& out, Range range) {
    object_.optional(name, [&](const Value& value) { out = value.number(range), count_alternative(value); });
  }
  template <class Variant>
  void vertices(std::string_view name, Variant& out) {
    object_.optional(name, [&](const Value& list) {
      MaskVertices chosen;
      for (const Value& member : list.list(1, limits::mask_vertices)) {
        chosen.vertices.push_back(static_cast<std::uint32_t>(member.integer({0, 4294967295.0})));
      }
      out = std::move(chosen), count_alternative(list);
    });
  }

  template <class T>
  static T read(const Value& value) {
    Object object(value);
    MemberReader reader(object);
    T result;
    members(reader, result);
    object.finish();
    return result;
  }

 private:
  void count_alternative(const Value& value) {
    if (++alternatives_ > 1) value.refuse("There is another shape beside this one.", "one shape");
  }

  Object& object_;
  int alternatives_ = 0;
};

/// A tool that changes what it touches works under a stroke, or everywhere, and not both.
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

bool has_opposite(const Command& command) {
  const auto is_any_of = [&]<class... Tools>(std::variant<Tools...>*) {
    return (std::holds_alternative<Tools>(command) || ...);
  };
  return !is_any_of(static_cast<std::variant<Smooth, Unify, Erase, Trim, Interpolate, Flow>*>(nullptr));
}

bool is_colour(Field field) { return shape_of(field).channels == 4; }
bool are_colours(const std::vector<Field>& fields) {
  return !fields.empty() && std::all_of(fields.begin(), fields.end(), is_colour);
}

/// Whether all that the tool changes differs from root to tip.
template <class Tool>
bool changes_colours_only(const Tool&) { return false; }
bool changes_colours_only(const Paint& paint) { return is_colour(paint.field); }
bool changes_colours_only(const Smooth& smooth) { return are_colours(smooth.fields); }
bool changes_colours_only(const Noise& noise) { return are_colours(noise.fields); }
bool changes_colours_only(const Erase& erase) { return are_colours(erase.fields); }
bool changes_colours_only(const Unify& unify) {
  return are_colours(unify.mean) && !unify.direction && !unify.inclination && !unify.length;
}

bool names_mask(Field field) { return field == Field::mask; }
bool names_mask(const std::vector<Field>& fields) { return std::count(fields.begin(), fields.end(), Field::mask) > 0; }

/// The mask lies outside of all layers.
template <class Tool>
void check_layer(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.layer; }) {
    bool mask = false;
    if constexpr (requires { tool.field; }) mask = mask || names_mask(tool.field);
    if constexpr (requires { tool.fields; }) mask = mask || names_mask(tool.fields);
    if constexpr (requires { tool.mean; }) mask = mask || names_mask(tool.mean);
    if (mask && !tool.layer.empty())
      value.refuse_below("layer", "The mask lies outside of all layers.", "no layer where the mask is changed");
  }
}

template <class Tool>
void check_brush(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.brush; }) {
    const Brush& brush = tool.brush;
    if (brush.invert && !has_opposite(tool))
      value.refuse_below("brush/invert", "The tool has no opposite.", "false");
    if (brush.strand_to <= brush.strand_from)
      value.refuse_below("brush/strand_to", "The part of the strand ends before it begins.", "above strand_from");
    if ((brush.strand_from > 0 || brush.strand_to < 1) && !changes_colours_only(tool)) {
      value.refuse_below("brush/strand_from", "Only colours differ from root to tip.",
                         "0 to 1, or a tool that changes nothing but root_colour and tip_colour");
    }
  }
}

template <class Tool>
void check(const Value&, const Tool&) {}

void check(const Value& value, const Comb& comb) {
  if (comb.flood != comb.direction.has_value()) {
    value.refuse_below("direction", "A flooding comb needs a direction, and a stroke brings its own.",
                       "with flood only");
  }
}

void check(const Value& value, const Blow& blow) {
  const bool own = value.tree().contains("source");
  if (blow.blower.empty() != own) value.refuse_below("source", "Wind has a source, or the name of a blower.", "one of source | blower");
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
    if (!key.direction && !key.length) value.refuse_below(pointer, "A key gives a direction or a length.", "direction | length");
    if (!key.direction && key.inclination)
      value.refuse_below(pointer + "/inclination", "An inclination comes with a direction.", "with direction only");
  }
}

void check(const Value& value, const Unify& unify) {
  if (!unify.direction && !unify.inclination && !unify.length && unify.mean.empty())
    value.refuse("Nothing is unified.", "one or more of direction | inclination | length | mean");
  const auto has = [&](Field field) { return std::count(unify.mean.begin(), unify.mean.end(), field) > 0; };
  if ((has(Field::direction) && (unify.direction || unify.inclination)) || (has(Field::length) && unify.length))
    value.refuse_below("mean", "A field goes to its mean or to a value.", "fields without a value");
}

template <class Tool>
void require_stroke(const Value& value, const Tool& tool) {
  if (!tool.stroke) value.refuse_below("stroke", "The tool needs a stroke.", "required");
}

void check(const Value& value, const Part& part) { require_stroke(value, part); }
void check(const Value& value, const Clump& clump) { require_stroke(value, clump); }

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
    value.refuse_below("field", "Other tools change this field.", "density | width | curl | clump | wetness | bare | mask | root_colour | tip_colour");
  if (paint.value > shape.most) value.refuse_below("value", "The value is beyond the field's range.", "[0, 1]");
}

void check(const Value& value, const ChangeMask& mask) {
  if (const auto* box = std::get_if<MaskBox>(&mask.shape); box && glm::any(glm::greaterThan(box->min, box->max)))
    value.refuse_below("box/max", "The box ends before it begins.", "at least min");
}

void check(const Value& value, const ApplyMap& map) {
  if (!fits(map.field, map.encoding)) refuse_encoding(value, map.field);
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

void check(const Value& value, const ChangeLayer& layer) {
  if (layer.action == LayerAction::set && !layer.weight && !layer.muted && layer.rename.empty())
    value.refuse("Nothing of the layer is set.", "one or more of weight | muted | rename");
  if (layer.action == LayerAction::move && !layer.above)
    value.refuse_below("above", "Nothing says where the layer moves to.", "required");
  if (layer.above == layer.name) value.refuse_below("above", "A layer cannot lie on itself.", "another layer");
}

template <class Tool>
Command read_tool(Object& object) {
  MemberReader reader(object);
  Tool tool;
  members(reader, tool);
  check_reach(object.value(), tool);
  check_view(object.value(), tool);
  check_brush(object.value(), tool);
  check_layer(object.value(), tool);
  check(object.value(), tool);
  return tool;
}

template <class... Tools>
std::vector<NamedReader> list_readers(std::variant<Tools...>*) {
  std::vector<NamedReader> readers;
  const auto add = [&]<class Tool>(Tool*) {
    if constexpr (ListedTool<Tool>) readers.push_back({op_of(Command(Tool{})), read_tool<Tool>});
  };
  (add(static_cast<Tools*>(nullptr)), ...);
  return readers;
}

}  // namespace

const std::vector<NamedReader>& tool_readers() {
  static const std::vector<NamedReader> readers = list_readers(static_cast<Command*>(nullptr));
  return readers;
}

}  // namespace pelage::json_parts
