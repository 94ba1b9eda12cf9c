#include "protocol/json/encode_tools.h"

#include "protocol/json/tool_members.h"

namespace pelage::json_parts {

namespace {

using json_names::text_of;

/// Writes the members of a tool into an object.
class MemberWriter {
 public:
  static constexpr bool reads = true;  // the tool is read
  explicit MemberWriter(Json& json) : json_(json) {}

  void stroke(const std::optional<Stroke>& stroke) {
    if (stroke) json_["stroke"] = json_of(*stroke);
  }
  void brush(const Brush& brush) { json_["brush"] = json_of(brush); }
  void boolean(const char* name, bool value) { json_[name] = value; }
  void boolean(const char* name, const std::optional<bool>& value) {
    if (value) json_[name] = *value;
  }
  void number(const char* name, double value, Range) { json_[name] = value; }
  void number(const char* name, const std::optional<double>& value, Range) {
    if (value) json_[name] = *value;
  }
  void integer(const char* name, int value, Range) { json_[name] = value; }
  void seed(const char* name, std::uint32_t value) { json_[name] = value; }
  void counter(const char* name, const std::optional<std::uint64_t>& value) {
    if (value) json_[name] = *value;
  }
  void text(const char* name, const std::string& text) {
    if (!text.empty()) json_[name] = text;
  }
  void text(const char* name, const std::optional<std::string>& text) {
    if (text) json_[name] = *text;
  }
  void required_text(const char* name, const std::string& text) { json_[name] = text; }
  void picture(const char* name, const std::string& text) { json_[name] = text; }
  void position(const char* name, glm::dvec3 position) { json_[name] = list(position); }
  void required_position(const char* name, glm::dvec3 position) { json_[name] = list(position); }
  void direction(const char* name, glm::dvec3 direction) { json_[name] = list(direction); }
  void direction(const char* name, const std::optional<glm::dvec3>& direction) {
    if (direction) json_[name] = list(*direction);
  }
  void colour(const char* name, glm::vec3 linear) { json_[name] = json_parts::colour(linear); }
  template <class E, std::size_t N>
  void name(const char* name, E value, const std::array<json_names::Name<E>, N>& names) {
    json_[name] = text_of(names, value);
  }
  void field(const char* name, Field field) { json_[name] = shape_of(field).name; }
  void fields(const char* name, const std::vector<Field>& fields, std::size_t) {
    json_[name] = Json::array();
    for (const Field field : fields) json_[name].push_back(shape_of(field).name);
  }
  template <class T>
  void object(const char* name, const T& value) {
    json_[name] = written(value);
  }
  template <class T>
  void objects(const char* name, const std::vector<T>& values, Count) {
    json_[name] = Json::array();
    for (const T& value : values) json_[name].push_back(written(value));
  }
  void curves(const char* name, const std::vector<std::vector<glm::dvec3>>& curves, Count, Count) {
    json_[name] = Json::array();
    for (const std::vector<glm::dvec3>& curve : curves) {
      Json points = Json::array();
      for (const glm::dvec3& point : curve) points.push_back(list(point));
      json_[name].push_back(std::move(points));
    }
  }
  template <class T, class Variant>
  void alternative(const char* name, const Variant& value) {
    if (const T* held = std::get_if<T>(&value)) json_[name] = written(*held);
  }
  template <class Variant>
  void alternative(const char* name, const Variant& value, Range) {
    if (const double* held = std::get_if<double>(&value)) json_[name] = *held;
  }
  template <class Variant>
  void vertices(const char* name, const Variant& value) {
    if (const auto* held = std::get_if<MaskVertices>(&value)) json_[name] = held->vertices;
  }

  template <class T>
  static Json written(const T& value) {
    Json json = Json::object();
    MemberWriter writer(json);
    members(writer, value);
    return json;
  }

 private:
  Json& json_;
};

}  // namespace

bool add_tool_members(Json& json, const Command& command) {
  return std::visit(
      [&](const auto& tool) {
        constexpr bool listed = ListedTool<std::decay_t<decltype(tool)>>;
        if constexpr (listed) {
          MemberWriter writer(json);
          members(writer, tool);
        }
        return listed;
      },
      command);
}

}  // namespace pelage::json_parts
