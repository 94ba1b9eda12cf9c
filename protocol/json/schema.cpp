#include "protocol/json/schema.h"

#include <charconv>
#include <cmath>

#include "protocol/json/colour.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/members_settings.h"

namespace pelage {

namespace json_parts {

namespace {

using Json = nlohmann::ordered_json;
using json_names::text_of;

Json reference(const std::string& name) { return {{"$ref", "#/components/schemas/" + name}}; }

/// Whole numbers without a point, floats with the digits that they were written with.
Json plain(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}
Json plain(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double number = 0;
  std::from_chars(text, end, number);
  return plain(number);
}
template <class Vector>
Json list(const Vector& vector) {
  Json values = Json::array();
  for (int i = 0; i < Vector::length(); ++i) values.push_back(plain(vector[i]));
  return values;
}

Json colour_default(glm::vec3 linear) {
  if (const auto text = text_of_colour(linear)) return *text;
  return list(linear);
}

Json number_schema(const char* type, Range range) {
  return {{"type", type}, {"minimum", plain(range.low)}, {"maximum", plain(range.high)}};
}
Json list_schema(Json items, Count count) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", count.min}, {"maxItems", count.max}};
}
/// A tool that can flood takes a stroke or floods, never both.
Json stroke_or_flood() {
  const Json stroke = {{"required", {"stroke"}}, {"properties", {{"flood", {{"const", false}}}}}};
  const Json flood = {{"required", {"flood"}}, {"properties", {{"flood", {{"const", true}}}, {"stroke", false}}}};
  return {stroke, flood};
}
Json text_schema(std::size_t min) {
  Json schema = {{"type", "string"}};
  if (min > 0) schema["minLength"] = min;
  schema["maxLength"] = limits::name_bytes;
  return schema;
}
/// Words that openapi.yaml explains, under a name of their own, for all members that take them.
template <class E>
constexpr const char* named_words = nullptr;
template <>
constexpr const char* named_words<Field> = "Field";
template <>
constexpr const char* named_words<Aov> = "Aov";

template <class E, std::size_t N>
Json words_schema(Json& all, const std::array<json_names::Name<E>, N>& names) {
  Json schema = {{"enum", Json::array()}};
  for (const auto& name : names) schema["enum"].push_back(name.text);
  if (!named_words<E>) return schema;
  all[named_words<E>] = std::move(schema);
  return reference(named_words<E>);
}

template <class T>
Json describe(Json& all);
template <>
Json describe<Command>(Json& all);

/// Collects the properties of a struct, and what its members refer to into `all`. The struct that it visits is a
/// default one: its values are the defaults.
class MemberSchemas {
 public:
  static constexpr bool reads = true;
  explicit MemberSchemas(Json& all) : all_(all) {}

  void type(const char* name, const char* words = "") { name_ = name, words_ = words; }
  bool takes(bool) { return true; }  // conditions between members are rules of openapi.yaml
  bool shows(bool) { return true; }

  template <class T>
  void number(MemberName name, const T& value, Range range, const char* words = "") {
    add(name, number_schema("number", range), default_of(value), words);
  }
  void number_or(const char* word, MemberName name, const std::optional<double>& value, Range range,
                 const char* words = "") {
    const Json either = {{"oneOf", {number_schema("number", range), {{"const", word}}}}};
    add(name, either, value ? plain(*value) : Json(word), words);
  }
  void numbers(MemberName name, const std::vector<double>&, Range range, Count count, const char* words = "") {
    add(name, list_schema(number_schema("number", range), count), {}, words);
  }
  void integer(MemberName name, int value, Range range, const char* words = "") {
    add(name, number_schema("integer", range), value, words);
  }
  void seed(MemberName name, std::uint32_t value, const char* words = "") {
    add(name, number_schema("integer", whole_number), value, words);
  }
  template <class T>
  void counter(MemberName name, const T& value, const char* words = "") {
    const Json schema = {{"type", "integer"}, {"minimum", 0}, {"maximum", std::numeric_limits<std::uint64_t>::max()}};
    add(name, schema, default_of(value), words);
  }
  template <class T>
  void boolean(MemberName name, const T& value, const char* words = "") {
    add(name, {{"type", "boolean"}}, default_of(value), words);
  }
  template <class T>
  void text(MemberName name, const T& text, const char* words = "") {
    add(name, text_schema(0), default_of(text), words);
  }
  void label(MemberName name, const std::string& text, const char* words = "") {
    add(name, text_schema(1), text.empty() ? Json() : Json(text), words);
  }
  void picture(MemberName name, const std::string&, const char* words = "", const char* word_for_none = nullptr) {
    Json schema = reference("PictureName");
    if (word_for_none) schema = {{"oneOf", {{{"const", word_for_none}}, schema}}};
    add(name, schema, {}, words);
  }
  template <class T>
  void position(MemberName name, const T& position, const char* words = "") {
    add(name, reference("Position"), default_of(position), words);
  }
  void triple(MemberName name, glm::dvec3 value, Range range, const char* words = "") {
    add(name, list_schema(number_schema("number", range), {3, 3}), list(value), words);
  }
  void triples(MemberName name, const std::optional<SphericalHarmonics>&, Range range, const char* words = "") {
    constexpr std::size_t count = std::tuple_size_v<SphericalHarmonics>;
    add(name, list_schema(list_schema(number_schema("number", range), {3, 3}), {count, count}), {}, words);
  }
  void pixel(MemberName name, glm::dvec2, const View&, const char* words = "") {
    add(name, list_schema(number_schema("number", {0, pixels.high}), {2, 2}), {}, words);
  }
  template <class T>
  void direction(MemberName name, const T& direction, const char* words = "") {
    add(name, reference("Direction"), default_of(direction), words);
  }
  void colour(MemberName name, glm::vec3 linear, const char* words = "") {
    add(name, reference("Colour"), colour_default(linear), words);
  }
  template <class E, std::size_t N>
  void name(MemberName name, E value, const std::array<json_names::Name<E>, N>& names, const char* words = "") {
    add(name, words_schema(all_, names), text_of(names, value), words);
  }
  template <class E, std::size_t N>
  void names(MemberName name, const std::vector<E>& values, const std::array<json_names::Name<E>, N>& names,
             std::size_t min, const char*, const char* words = "") {
    Json schema = list_schema(words_schema(all_, names), {min, N}), defaults = Json::array();
    schema["uniqueItems"] = true;
    for (const E value : values) defaults.push_back(text_of(names, value));
    add(name, schema, defaults, words);
  }
  template <class T>
  void object(MemberName name, const T&, const char* words = "") {
    add(name, describe<T>(all_), {}, words);
  }
  template <class T>
  void object(MemberName name, const std::optional<T>&, const char* words = "") {
    add(name, describe<T>(all_), {}, words);
  }
  template <class T>
  void objects(MemberName name, const std::vector<T>&, Count count, const char* words = "") {
    add(name, list_schema(describe<T>(all_), count), {}, words);
  }
  void curves(MemberName name, const std::vector<std::vector<glm::dvec3>>&, Count count, Count points,
              const char* words = "") {
    add(name, list_schema(list_schema(reference("Position"), points), count), {}, words);
  }
  template <class T, class Variant>
  void alternative(MemberName name, const Variant&, const char* words = "") {
    add(name, describe<T>(all_), {}, words);
  }
  template <class Variant>
  void alternative(MemberName name, const Variant&, Range range, const char* words = "") {
    add(name, number_schema("number", range), {}, words);
  }
  template <class Variant>
  void vertices(MemberName name, const Variant&, const char* words = "") {
    add(name, list_schema(number_schema("integer", whole_number), {1, limits::mask_vertices}), {}, words);
  }
  void special(MemberName name, const Camera& camera, const char* words = "") {
    add(name, reference("Camera"), {{"auto", text_of(json_names::auto_views, camera.automatic)}}, words);
  }
  void special(MemberName name, const Backdrop<true>& backdrop, const char* words = "") {
    const Json known = {{"enum", {"transparent", "studio"}}};
    add(name, {{"oneOf", {known, reference("Colour")}}}, colour_default(backdrop.colour), words);
  }
  void special(MemberName name, const Knobs&, const char* words = "") {
    add(name, {{"oneOf", {reference("Tier"), describe<Knobs>(all_)}}}, "interactive", words);
  }
  void special(MemberName name, const std::optional<Tracing>&, const char* words = "") {
    const Json boolean = {{"type", "boolean"}};
    add(name, {{"oneOf", {boolean, describe<Tracing>(all_)}}}, {}, words);
  }
  template <class Place>
  void place(const Place&) {
    add("position", reference("Position"), {}, "");
    add("screen", list_schema(number_schema("number", screen_coordinate), {2, 2}), {},
        "Pixels from the top left, y down, centres at .5.");
    add("triangle", number_schema("integer", whole_number), {}, "");
    add("barycentric", reference("Barycentric"), {}, "");
  }

  /// The schema of the struct; of a command with the word that it has as `op`.
  Json finish(const char* op = nullptr) {
    Json schema, required = std::move(required_), properties = std::move(properties_);
    if (*words_) schema["description"] = words_;
    schema["type"] = "object";
    if (op) properties["op"] = {{"const", op}}, required.push_back("op");
    if (properties.contains("flood")) schema["oneOf"] = stroke_or_flood();
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    return schema;
  }
  std::string name() const { return name_; }

 private:
  template <class T>
  static Json default_of(const T& value) {
    if constexpr (std::is_floating_point_v<T>) return plain(value);
    if constexpr (std::is_same_v<T, glm::dvec3>) return list(value);
    if constexpr (!std::is_floating_point_v<T> && !std::is_same_v<T, glm::dvec3>) return value;
  }
  template <class T>
  static Json default_of(const std::optional<T>& value) {
    return value ? default_of(*value) : Json();
  }
  void add(MemberName name, Json schema, Json fallback, const char* words) {
    const bool has_default = name.presence == Presence::defaulted || name.presence == Presence::sparse;
    if (has_default && !fallback.is_null()) schema["default"] = std::move(fallback);
    if (*words) schema["description"] = words;
    if (name.presence == Presence::required) required_.push_back(name.text);
    properties_[name.text] = std::move(schema);
  }

  Json& all_;
  const char *name_ = "", *words_ = "";
  Json properties_ = Json::object(), required_ = Json::array();
};

template <class T>
Json describe(Json& all) {
  MemberSchemas visitor(all);
  const T defaults{};
  members(visitor, defaults);
  all[visitor.name()] = visitor.finish();
  return reference(visitor.name());
}

template <class Tool>
void describe_command(Json& all, Json& command) {
  MemberSchemas visitor(all);
  const Tool defaults{};
  members(visitor, defaults);
  const char* op = op_of(Command(defaults));
  all[visitor.name()] = visitor.finish(op);
  const Json to = reference(visitor.name());
  command["oneOf"].push_back(to);
  command["discriminator"]["mapping"][op] = to["$ref"];
}

template <class... Tools>
void describe_commands(Json& all, Json& command, const std::variant<Tools...>*) {
  (describe_command<Tools>(all, command), ...);
}

template <>
Json describe<Command>(Json& all) {
  if (!all.contains("Command")) {
    Json command = {{"oneOf", Json::array()}, {"discriminator", {{"propertyName", "op"}}}};
    describe_commands(all, command, static_cast<const Command*>(nullptr));
    all["Command"] = std::move(command);
  }
  return reference("Command");
}

}  // namespace

}  // namespace json_parts

nlohmann::ordered_json request_schemas() {
  using namespace json_parts;
  Json all = Json::object();
  describe<NewScene>(all), describe<Batch>(all), describe<AmendRequest>(all), describe<BranchRequest>(all);
  describe<StepsBody>(all), describe<RevisionBody>(all), describe<Subdivide>(all);
  describe<FrameRequest>(all), describe<PickRequest>(all);
  describe<ImportOptions>(all), describe<EnvironmentUpload>(all), describe<Revisions>(all);  // in the address
  describe<MapRequest>(all), describe<MapUpload>(all);
  return all;
}

}  // namespace pelage
