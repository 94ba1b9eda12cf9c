#include "protocol/json/write.h"

#include "protocol/json/colour.h"
#include "protocol/json/members_answers.h"
#include "protocol/json/members_calibration.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/members_settings.h"

namespace pelage::json_parts {

using json_names::text_of;

namespace {

template <glm::length_t N>
Json list(const glm::vec<N, double>& vector) {
  Json values = Json::array();
  for (glm::length_t i = 0; i < N; ++i) values.push_back(vector[i]);
  return values;
}

Json colour_of(glm::vec3 linear) {
  if (const auto text = text_of_colour(linear)) return *text;
  return list(glm::dvec3(linear));
}

Json form_of(const Backdrop<true>& backdrop) {
  if (backdrop.kind == Background::colour) return colour_of(backdrop.colour);
  return backdrop.kind == Background::studio ? "studio" : "transparent";
}

Json form_of(const Knobs& knobs) { return written(knobs); }

/// Writes the members of a struct into an object.
class MemberWriter {
 public:
  static constexpr bool reads = true;
  explicit MemberWriter(Json& json) : json_(json) {}

  void type(const char*, const char* = "") {}
  void answer(const char*, const char* = "") {}
  bool takes(bool condition) { return condition; }
  bool shows(bool condition) { return condition; }
  bool has(const char*, bool condition) { return condition; }

  void number(MemberName name, double value, Range, const char* = "") { json_[name.text] = value; }
  template <class T>
  void number(MemberName name, const std::optional<T>& value, Range, const char* = "") {
    if (value) json_[name.text] = *value;
  }
  void number_or(const char* word, MemberName name, const std::optional<double>& value, Range, const char* = "") {
    json_[name.text] = value ? Json(*value) : Json(word);
  }
  void numbers(MemberName name, const std::vector<double>& values, Range, Count, const char* = "") {
    if (says(name, values.empty())) json_[name.text] = values;
  }
  void integer(MemberName name, int value, Range, const char* = "") { json_[name.text] = value; }
  void integers(MemberName name, const std::vector<int>& values, Range, Count, const char* = "") {
    json_[name.text] = values;
  }
  void seed(MemberName name, std::uint32_t value, const char* = "") { json_[name.text] = value; }
  void counter(MemberName name, std::uint64_t value, const char* = "") { json_[name.text] = value; }
  void counter(MemberName name, const std::optional<std::uint64_t>& value, const char* = "") {
    if (value) json_[name.text] = *value;
  }
  void boolean(MemberName name, bool value, const char* = "") { json_[name.text] = value; }
  void boolean(MemberName name, const std::optional<bool>& value, const char* = "") {
    if (value) json_[name.text] = *value;
  }
  void text(MemberName name, const std::string& text, const char* = "", std::size_t = 0) {
    if (says(name, text.empty())) json_[name.text] = text;
  }
  void text(MemberName name, const std::optional<std::string>& text, const char* = "", std::size_t = 0) {
    if (text) json_[name.text] = *text;
  }
  void texts(MemberName name, const std::vector<std::string>& texts, const char* = "") {
    if (says(name, texts.empty())) json_[name.text] = texts;
  }
  void label(MemberName name, const std::string& text, const char* = "") { json_[name.text] = text; }
  void picture(MemberName name, const std::string& text, const char* = "", const char* word_for_none = "") {
    if (says(name, text.empty())) json_[name.text] = text.empty() ? word_for_none : text;
  }
  void hash(MemberName name, FieldsHash hash, const char* = "") { json_[name.text] = to_hex(hash); }
  void json(MemberName name, const std::string& text, const char* = "") {
    if (says(name, text.empty())) json_[name.text] = Json::parse(text, nullptr, false);
  }
  void position(MemberName name, glm::dvec3 position, const char* = "") { json_[name.text] = list(position); }
  void position(MemberName name, const std::optional<glm::dvec3>& position, const char* = "") {
    if (position) json_[name.text] = list(*position);
  }
  template <glm::length_t N>
  void vector(MemberName name, const glm::vec<N, double>& value, Range, const char* = "") {
    json_[name.text] = list(value);
  }
  void vectors(MemberName name, const std::optional<SphericalHarmonics>& values, Range, const char* = "") {
    if (!values) return;
    for (const glm::dvec3& value : *values) json_[name.text].push_back(list(value));
  }
  void pixel(MemberName name, glm::dvec2 value, const View&, const char* = "") { json_[name.text] = list(value); }
  void direction(MemberName name, glm::dvec3 direction, const char* = "") { json_[name.text] = list(direction); }
  void direction(MemberName name, const std::optional<glm::dvec3>& direction, const char* = "") {
    if (direction) json_[name.text] = list(*direction);
  }
  void colour(MemberName name, glm::vec3 linear, const char* = "") { json_[name.text] = colour_of(linear); }
  template <class E, std::size_t N>
  void name(MemberName name, E value, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    json_[name.text] = text_of(names, value);
  }
  template <class E, std::size_t N>
  void name(MemberName name, const std::optional<E>& value, const std::array<json_names::Name<E>, N>& names,
            const char* = "") {
    if (value) json_[name.text] = text_of(names, *value);
  }
  template <class E, std::size_t N>
  void word(MemberName name, const std::string& word, const std::array<json_names::Name<E>, N>&, const char* = "") {
    json_[name.text] = word;
  }
  template <class E, std::size_t N>
  void names(MemberName name, const std::vector<E>& values, const std::array<json_names::Name<E>, N>& names,
             std::size_t, const char*, const char* = "") {
    Json& words = json_[name.text] = Json::array();
    for (const E value : values) words.push_back(text_of(names, value));
  }
  template <class T>
  void object(MemberName name, const T& value, const char* = "") {
    json_[name.text] = written(value);
  }
  template <class T>
  void object(MemberName name, const std::optional<T>& value, const char* = "") {
    if (value) json_[name.text] = written(*value);
  }
  template <class T>
  void objects(MemberName name, const std::vector<T>& values, Count, const char* = "") {
    Json& objects = json_[name.text] = Json::array();
    for (const T& value : values) objects.push_back(written(value));
  }
  void curves(MemberName name, const std::vector<std::vector<glm::dvec3>>& curves, Count, Count, const char* = "") {
    Json& lists = json_[name.text] = Json::array();
    for (const std::vector<glm::dvec3>& curve : curves) {
      Json& points = lists.emplace_back(Json::array());
      for (const glm::dvec3& point : curve) points.push_back(list(point));
    }
  }
  template <class T, class Variant>
  void alternative(MemberName name, const Variant& value, const char* = "") {
    if (const T* active = std::get_if<T>(&value)) json_[name.text] = written(*active);
  }
  template <class Variant>
  void alternative(MemberName name, const Variant& value, Range, const char* = "") {
    if (const double* active = std::get_if<double>(&value)) json_[name.text] = *active;
  }
  template <class Variant>
  void vertices(MemberName name, const Variant& value, const char* = "") {
    if (const auto* active = std::get_if<MaskVertices>(&value)) json_[name.text] = active->vertices;
  }
  template <class T>
  void special(MemberName name, const T& value, const char* = "") {
    json_[name.text] = form_of(value);
  }
  void special(MemberName name, const std::optional<Tracing>& value, const char* = "") { object(name, value); }
  void sample_position(const std::variant<PositionSample, ScreenSample, SurfaceSample>& position) {
    if (const auto* point = std::get_if<PositionSample>(&position)) {
      json_["position"] = list(point->position);
    } else if (const auto* pixel = std::get_if<ScreenSample>(&position)) {
      json_["screen"] = list(pixel->screen);
    } else {
      const auto& surface = std::get<SurfaceSample>(position);
      json_["triangle"] = surface.triangle;
      json_["barycentric"] = list(surface.barycentric);
    }
  }

 private:
  static bool says(MemberName name, bool empty) { return !(empty && name.presence == Presence::sparse); }

  Json& json_;
};

}  // namespace

template <>
Json written(const Command& command) {
  Json json = {{"op", op_of(command)}};
  MemberWriter writer(json);
  std::visit([&](const auto& c) { members(writer, c); }, command);
  return json;
}

template <class T>
Json written(const T& value) {
  Json json = Json::object();
  MemberWriter writer(json);
  members(writer, value);
  return json;
}

template Json written(const NewScene&);
template Json written(const FrameRequest&);
template Json written(const Knobs&);
template Json written(const PickRequest&);
template Json written(const BranchRequest&);
template Json written(const AmendRequest&);
template Json written(const Batch&);
template Json written(const Calibration&);
template Json written(const SceneSummary&);
template Json written(const SceneList&);
template Json written(const CommandAnswer&);
template Json written(const Comparison&);
template Json written(const SettingsAnswer&);
template Json written(const Log&);
template Json written(const SceneEvent&);
template Json written(const ChangeEvent&);
template Json written(const PickAnswer&);
template Json written(const RecipeRequest&);
template Json written(const RecipeAnswer&);
template Json written(const MapAnswer&);
template Json written(const PictureAnswer&);
template Json written(const FrameEstimate&);
template Json written(const FrameCost&);
template Json written(const ExportAnswer&);
template Json written(const FrameProgressList&);
template Json written(const FrameCounters&);
template Json written(const TraceReport&);
template Json written(const Problem&);

}  // namespace pelage::json_parts
