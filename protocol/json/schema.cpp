#include "protocol/json/schema.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "protocol/json/encode.h"
#include "protocol/json/members_answers.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_job.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/members_settings.h"
#include "protocol/json/named_words.h"
#include "protocol/json/schema_values.h"
#include "protocol/json/write.h"

namespace pelage {

namespace json_parts {

namespace {

using json_names::text_of;

template <class E, std::size_t N>
Json words_schema(Json& all, const std::array<json_names::Name<E>, N>& names) {
  Json schema = {{"enum", Json::array()}};
  for (const auto& name : names) schema["enum"].push_back(name.text);
  constexpr NamedWords named = named_words<E>;
  if constexpr (named.name == nullptr) {
    return schema;
  } else {
    all[named.name] = described(std::move(schema), named.meaning);
    return reference(named.name);
  }
}

template <class T>
Json describe(Json& all);
template <>
Json describe<Command>(Json& all);

/// Returns a default struct in each form that it has on the wire.
template <class T>
std::vector<T> forms() {
  return {T{}};
}
template <>
std::vector<Camera> forms() {
  return {Camera{}, Camera{.automatic = AutoView::none}};
}
template <>
std::vector<PickRequest> forms() {
  return {PickRequest{}, PickRequest{.ray = PickRay{}}, PickRequest{.farthest = PickFarthest{}},
          PickRequest{.nearest = glm::dvec3(0)}};
}
template <>
std::vector<PickAnswer> forms() {
  return {PickAnswer{}, PickAnswer{.hit = true}};
}

/// Collects the properties of a struct, and adds the schemas that its members refer to to `all`. The struct that it
/// visits holds the default values.
class MemberSchemas {
 public:
  static constexpr bool reads = true;
  explicit MemberSchemas(Json& all, bool one_form = false) : all_(all), one_form_(one_form) {}

  void type(const char* name, const char* words = "") { name_ = name, words_ = words; }
  void answer(const char* name, const char* words = "") { type(name, words), answer_ = true; }
  bool takes(bool condition) { return condition || !one_form_; }  // otherwise openapi.yaml has the rules
  bool shows(bool) { return true; }
  bool has(const char*, bool condition) { return condition; }

  template <class T>
  void number(MemberName name, const T& value, Range range, const char* words = "") {
    add(name, number_schema("number", range), default_of(value), words);
  }
  void number_or(const char* word, MemberName name, const std::optional<double>& value, Range range,
                 const char* words = "") {
    const Json either = {{"oneOf", {number_schema("number", range), {{"const", word}}}}};
    add(name, either, value ? plain_number(*value) : Json(word), words);
  }
  void numbers(MemberName name, const std::vector<double>&, Range range, Count count, const char* words = "") {
    add(name, list_schema(number_schema("number", range), count), {}, words);
  }
  void integers(MemberName name, const std::vector<int>&, Range range, Count count, const char* words = "") {
    add(name, list_schema(number_schema("integer", range), count), {}, words);
  }
  void integer(MemberName name, int value, Range range, const char* words = "") {
    add(name, number_schema("integer", range), value, words);
  }
  void seed(MemberName name, std::uint32_t value, const char* words = "") {
    add(name, number_schema("integer", uint32_range), value, words);
  }
  template <class T>
  void counter(MemberName name, const T& value, const char* words = "") {
    Json schema = {{"type", "integer"}, {"minimum", 0}};
    if (!answer_) schema["maximum"] = std::numeric_limits<std::uint64_t>::max();
    add(name, schema, default_of(value), words);
  }
  template <class T>
  void boolean(MemberName name, const T& value, const char* words = "") {
    if (name.presence == Presence::tag) return add(name, {{"const", default_of(value)}}, {}, words);
    add(name, {{"type", "boolean"}}, default_of(value), words);
  }
  template <class T>
  void text(MemberName name, const T& text, const char* words = "", std::size_t max = limits::name_bytes) {
    add(name, text_schema(0, max), default_of(text), words);
  }
  void texts(MemberName name, const std::vector<std::string>&, const char* words = "") {
    add(name, list_schema(text_schema(0, any_length), any_count), {}, words);
  }
  void label(MemberName name, const std::string& text, const char* words = "") {
    add(name, text_schema(1), text.empty() ? Json() : Json(text), words);
  }
  void picture(MemberName name, const std::string&, const char* words = "", const char* word_for_none = nullptr) {
    Json schema = reference("PictureName");
    if (word_for_none) schema = {{"oneOf", {{{"const", word_for_none}}, schema}}};
    add(name, schema, {}, words);
  }
  void hash(MemberName name, FieldsHash, const char* words = "") { add(name, reference("FieldsHash"), {}, words); }
  void json(MemberName name, const std::string&, const char* words = "") {
    Json schema = {{"type", "object"}};
    if (answer_) schema = {{"type", {"object", "array"}}, {"items", {{"type", "object"}}}};
    add(name, std::move(schema), {}, words);
  }
  void any(MemberName name, const std::string&, const char* words = "") {
    add(name, {{"type", {"number", "string", "boolean", "array"}}}, {}, words);
  }
  template <class T>
  void document(MemberName name, const std::string&, const char* words = "") {
    add(name, describe<T>(all_), {}, words);
  }
  template <class T>
  void position(MemberName name, const T& position, const char* words = "") {
    add(name, reference("Position"), default_of(position), words);
  }
  template <glm::length_t N>
  void vector(MemberName name, const glm::vec<N, double>& value, Range range, const char* words = "") {
    add(name, list_schema(number_schema("number", range), Count{N, N}), plain_list(value), words);
  }
  void vectors(MemberName name, const std::optional<SphericalHarmonics>&, Range range, const char* words = "") {
    constexpr std::size_t count = std::tuple_size_v<SphericalHarmonics>;
    add(name, list_schema(list_schema(number_schema("number", range), {3, 3}), {count, count}), {}, words);
  }
  void pixel(MemberName name, glm::dvec2, const View&, const char* words = "") {
    add(name, list_schema(number_schema("number", {0, pixels.high, "pixels"}), {2, 2}), {}, words);
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
  void name(MemberName name, const std::optional<E>&, const std::array<json_names::Name<E>, N>& names,
            const char* words = "") {
    add(name, words_schema(all_, names), {}, words);
  }
  template <class E, std::size_t N>
  void word(MemberName name, const std::string&, const std::array<json_names::Name<E>, N>& names,
            const char* words = "") {
    add(name, words_schema(all_, names), {}, words);
  }
  template <class E, std::size_t N>
  void names(MemberName name, const std::vector<E>& values, const std::array<json_names::Name<E>, N>& names,
             std::size_t min, const char*, const char* words = "") {
    Json schema = list_schema(words_schema(all_, names), {min, N}), defaults = Json::array();
    schema["uniqueItems"] = true;
    for (const E value : values) defaults.push_back(text_of(names, value));
    add(name, schema, defaults, words);
  }
  void object(MemberName name, const Camera& camera, const char* words = "") {
    add(name, describe<Camera>(all_), {{"auto", text_of(json_names::auto_views, camera.automatic)}}, words);
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
    add(name, list_schema(number_schema("integer", uint32_range), {1, limits::mask_vertices}), {}, words);
  }
  void special(MemberName name, const Backdrop<true>& backdrop, const char* words = "") {
    const Json known = {{"enum", {"transparent", "studio"}}};
    add(name, {{"oneOf", {known, reference("Colour")}}}, colour_default(backdrop.colour), words);
  }
  void special(MemberName name, const Knobs&, const char* words = "") {
    add(name, {{"oneOf", {words_schema(all_, json_names::tiers), describe<Knobs>(all_)}}}, "interactive", words);
  }
  void special(MemberName name, const std::optional<Tracing>&, const char* words = "") {
    const Json boolean = {{"type", "boolean"}};
    add(name, {{"oneOf", {boolean, describe<Tracing>(all_)}}}, {}, words);
  }
  template <class Position>
  void sample_position(const Position&) {
    add("position", reference("Position"), {}, "A point on the skin, in the fur or anywhere else.");
    add("screen", list_schema(number_schema("number", screen_coordinate), {2, 2}), {},
        "A pixel of the stroke's view: from the top left, y down, centres at .5.");
    add("triangle", number_schema("integer", uint32_range), {}, "Number of a triangle.");
    add("barycentric", reference("Barycentric"), {}, "");
  }

  /// Returns the schema of the struct; that of a command also has its `op`.
  Json finish(const char* op = nullptr) {
    Json schema = {{"type", "object"}}, required = std::move(required_), properties = std::move(properties_);
    if (op) properties["op"] = {{"const", op}, {"description", "Name of the command."}}, required.push_back("op");
    if (properties.contains("flood")) schema["oneOf"] = stroke_or_flood();
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    properties_ = Json::object(), required_ = Json::array();
    return schema;
  }
  /// Ends a form of the struct; the next one begins with no members.
  void end_form(const char* op = nullptr) { forms_.push_back(finish(op)); }
  /// Adds the schema of all forms to `all` under the struct's name, and returns a reference to it.
  Json named() {
    all_[name_] = described(forms_.size() > 1 ? Json{{"oneOf", forms_}} : forms_[0], words_);
    return reference(name_);
  }

 private:
  template <class T>
  static Json default_of(const T& value) {
    if constexpr (std::is_floating_point_v<T>) return plain_number(value);
    if constexpr (std::is_same_v<T, glm::dvec3>) return plain_list(value);
    if constexpr (!std::is_floating_point_v<T> && !std::is_same_v<T, glm::dvec3>) return value;
  }
  template <class T>
  static Json default_of(const std::optional<T>& value) {
    return value ? default_of(*value) : Json();
  }
  void add(MemberName name, Json schema, Json fallback, const char* words) {
    const bool has_default = name.presence == Presence::defaulted || name.presence == Presence::sparse;
    if (has_default && !answer_ && !fallback.is_null()) schema["default"] = std::move(fallback);
    if (is_required(name, answer_)) required_.push_back(name.text);
    properties_[name.text] = described(std::move(schema), words);
  }

  Json& all_;
  bool one_form_;        // the struct has several forms, each with a schema
  bool answer_ = false;  // all members are required, except sparse and bare ones
  const char *name_ = "", *words_ = "";
  Json forms_ = Json::array(), properties_ = Json::object(), required_ = Json::array();
};

void add_command(Json& command, const char* op, const Json& to) {
  command["oneOf"].push_back(to);
  command["discriminator"]["mapping"][op] = to["$ref"];
}

template <class T>
Json describe(Json& all) {
  const std::vector<T> values = forms<T>();
  MemberSchemas visitor(all, values.size() > 1);
  for (const T& value : values) {
    members(visitor, value);
    visitor.end_form();
  }
  return visitor.named();
}

template <class Tool>
void describe_command(Json& all, Json& command) {
  MemberSchemas visitor(all);
  members(visitor, Tool{});
  visitor.end_form(Tool::op);
  add_command(command, Tool::op, visitor.named());
}

template <class... Tools>
void describe_commands(Json& all, Json& command, const std::variant<Tools...>*) {
  (describe_command<Tools>(all, command), ...);
}

template <>
Json describe<Command>(Json& all) {
  if (!all.contains("Command")) {
    Json command = {{"description", "A command; `op` says which."},
                    {"oneOf", Json::array()},
                    {"discriminator", {{"propertyName", "op"}}}};
    describe_commands(all, command, static_cast<const Command*>(nullptr));
    all["Command"] = std::move(command);
  }
  return reference("Command");
}

}  // namespace

}  // namespace json_parts

nlohmann::ordered_json schemas() {
  using namespace json_parts;
  Json all = shapes();
  describe<NewScene>(all), describe<Batch>(all), describe<AmendRequest>(all), describe<BranchRequest>(all);
  describe<StepsBody>(all), describe<RevisionBody>(all), describe<Subdivide>(all), describe<TurnModel>(all),
      describe<SceneName>(all);
  describe<FrameRequest>(all), describe<PickRequest>(all), describe<RecipeRequest>(all);
  describe<ImportOptions>(all), describe<EnvironmentUpload>(all), describe<Revisions>(all);  // query parameters
  describe<AtRevision>(all), describe<MapRequest>(all), describe<MapUpload>(all), describe<MeshRequest>(all);
  describe<GuideUpload>(all);
  describe<ExportRequest>(all), describe<ExportAnswer>(all);
  describe<SceneList>(all), describe<CommandAnswer>(all), describe<Comparison>(all);
  describe<SettingsAnswer>(all);
  describe<Log>(all), describe<SceneEvent>(all), describe<ChangeEvent>(all);
  describe<PickAnswer>(all), describe<RecipeAnswer>(all), describe<PictureAnswer>(all), describe<Problem>(all);
  describe<FrameEstimate>(all), describe<FrameCounters>(all), describe<TraceReport>(all);  // response headers
  describe<FrameCost>(all), describe<FrameProgressList>(all);
  describe<MapAnswer>(all);
  return all;
}

std::string job_schema() {
  using namespace json_parts;
  Json all = shapes();
  const Json job = describe<RenderJob>(all);
  const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                       {"title", "A job of pelage-render"},
                       {"$ref", job["$ref"]},
                       {"components", {{"schemas", std::move(all)}}}};
  return schema.dump(2);
}

}  // namespace pelage
