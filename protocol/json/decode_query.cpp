// Decodes query parameters: they become the JSON document that they stand for, so that one decoder makes all checks.
#include <algorithm>
#include <sstream>
#include <vector>

#include "protocol/json/decode.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/parse.h"
#include "protocol/json/read.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

using json_parts::Backdrop, json_parts::MemberName, json_parts::members;
using nlohmann::json;

enum class Kind { text, number, list, names, boolean, crop };  // lists, names and crops are separated by commas

/// A parameter, and the JSON pointer of what it stands for.
struct Parameter {
  std::string name, pointer;
  Kind kind;
};

/// Collects the query parameters of a request: its members, and those of its camera and its knobs.
class QueryMembers {
 public:
  static constexpr bool reads = true;

  std::vector<Parameter> parameters;

  void type(const char*, const char* = "") {}
  bool takes(bool) { return true; }
  bool shows(bool) { return true; }
  bool has(const char*, bool condition) { return condition; }
  void number(MemberName name, const auto&, Range, const char* = "") { add(name, Kind::number); }
  void integers(MemberName name, const auto&, Range, Count, const char* = "") { add(name, Kind::list); }
  void integer(MemberName name, const auto&, Range, const char* = "") { add(name, Kind::number); }
  void counter(MemberName name, const auto&, const char* = "") { add(name, Kind::number); }
  void seed(MemberName name, const auto&, const char* = "") { add(name, Kind::number); }
  void boolean(MemberName name, const auto&, const char* = "") { add(name, Kind::boolean); }
  void text(MemberName name, const auto&, const char* = "") { add(name, Kind::text); }
  void position(MemberName name, const auto&, const char* = "") { add(name, Kind::list); }
  void direction(MemberName name, const auto&, const char* = "") { add(name, Kind::list); }
  void name(MemberName name, const auto&, const auto&, const char* = "") { add(name, Kind::text); }
  void names(MemberName name, const auto&, const auto&, std::size_t, const char*, const char* = "") {
    add(name, Kind::names);
  }
  void object(MemberName name, const std::optional<Look>&, const char* = "") {
    parameters.push_back({"colour_source", std::string("/") + name.text + "/colour_source", Kind::text});
  }
  void object(MemberName name, const Rasterizing& raster, const char* = "") { add_below(name, raster); }
  void object(MemberName, const Tracing&, const char* = "") {}  // not available in a URL, and neither is the next
  void object(MemberName, const Layering&, const char* = "") {}
  void object(MemberName name, const std::optional<Crop>&, const char* = "") { add(name, Kind::crop); }
  void object(MemberName name, const Camera&, const char* = "") {
    for (const Camera& form : {Camera{}, Camera{.automatic = AutoView::none}}) add_below(name, form);
  }
  void special(MemberName name, const Knobs& knobs, const char* = "") {
    add(name, Kind::text);
    add_below(name, knobs);
  }
  void special(MemberName name, const Backdrop<true>&, const char* = "") { add(name, Kind::text); }
  void special(MemberName, const std::optional<Tracing>&, const char* = "") {}

 private:
  /// Adds the parameters below a member. A camera's automatic view has the name of the camera itself.
  void add_below(MemberName name, const auto& value) {
    QueryMembers below;
    members(below, value);
    for (const Parameter& one : below.parameters) {
      parameters.push_back(
          {one.name == "auto" ? name.text : one.name, std::string("/") + name.text + one.pointer, one.kind});
    }
  }
  void add(MemberName name, Kind kind) { parameters.push_back({name.text, std::string("/") + name.text, kind}); }
};

template <class T>
const std::vector<Parameter>& parameters_of() {
  static const std::vector<Parameter> all = [] {
    QueryMembers visitor;
    const T defaults{};
    members(visitor, defaults);
    return std::move(visitor.parameters);
  }();
  return all;
}

json names_of(const std::string& text) {
  json names = json::array();
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

/// Converts ".5, 1" to "[0.5,1]": each number becomes one that JSON allows.
std::string list_of(std::string_view text) {
  std::string list = "[";
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
    list += as_json_number(text.substr(first, end - first)) + (end < text.size() ? ',' : ']');
    begin = end + 1;
  }
  return list;
}

/// Converts a list of left, top, width and height to a crop; returns the text for anything else.
json crop_of(const json& list, const std::string& text) {
  if (!list.is_array() || list.size() != 4) return text;
  return {{"left", list[0]}, {"top", list[1]}, {"width", list[2]}, {"height", list[3]}};
}

/// Converts a parameter to JSON. What is not a number, list or boolean stays text, so that the decoder says what it
/// expected.
json value_of(const std::string& text, Kind kind) {
  if (kind == Kind::text) return text;
  if (kind == Kind::names) return names_of(text);
  const bool list = kind == Kind::list || kind == Kind::crop;
  if (list && text.find_first_not_of("0123456789+-.eE, ") != std::string::npos) return text;
  json value = json::parse(list ? list_of(text) : as_json_number(text), nullptr, false);
  if (kind == Kind::crop) return crop_of(value, text);
  const bool fits = kind == Kind::number ? value.is_number()
                    : kind == Kind::list ? value.is_array()
                                         : value.is_boolean();
  return fits ? value : json(text);
}

Status set_parameter(json& document, const Parameter& parameter, const std::string& text) {
  const json::json_pointer pointer(parameter.pointer);
  json& parent = document[pointer.parent_pointer()];
  const bool knobs_and_tier = parent.is_string() || (document.contains(pointer) && document[pointer].is_object());
  if (knobs_and_tier) {
    return failure(Code::invalid, "A tier and single knobs exclude each other.", "/quality", "a tier or knobs");
  }
  if (document.contains(pointer)) {
    return failure(Code::malformed, "The parameter \"" + parameter.name + "\" is given twice.", parameter.pointer,
                   "each name once");
  }
  document[pointer] = value_of(text, parameter.kind);
  return {};
}

/// Returns the document that the parameters stand for.
Result<json> document_of(const Query& query, const std::vector<Parameter>& parameters) {
  json document = json::object();
  for (const auto& [name, text] : query) {
    const Parameter* found = nullptr;
    std::vector<std::string_view> known;
    for (const Parameter& parameter : parameters) {
      known.push_back(parameter.name);
      if (parameter.name == name) found = &parameter;
    }
    if (!found) {
      return failure(Code::invalid, "There is no parameter of that name.", pointer_step(name), "",
                     nearest_name(name, known));
    }
    if (!is_utf8(text)) return failure(Code::malformed, "The parameter is no UTF-8.", found->pointer, "UTF-8");
    if (Status status = set_parameter(document, *found, text); !status.ok()) return status;
  }
  return document;
}

template <class T>
Result<T> decode_query(const Query& query) {
  const auto document = document_of(query, parameters_of<T>());
  if (!document) return document.status();
  Status first_failure;
  T result = json_parts::read<T>(Value(*document, "", first_failure));
  if (!first_failure.ok()) return first_failure;
  return result;
}

}  // namespace

Result<FrameRequest> decode_frame_query(const Query& query) { return decode_query<FrameRequest>(query); }

Result<Tracing> decode_tracing_query(const Query& query) { return decode_query<Tracing>(query); }

Result<ImportOptions> decode_import_query(const Query& query) { return decode_query<ImportOptions>(query); }

Result<MeshRequest> decode_mesh_query(const Query& query) { return decode_query<MeshRequest>(query); }

Result<ExportRequest> decode_export_query(const Query& query) { return decode_query<ExportRequest>(query); }

Result<MapRequest> decode_map_query(const Query& query) { return decode_query<MapRequest>(query); }

Result<MapUpload> decode_map_upload_query(const Query& query) { return decode_query<MapUpload>(query); }
Result<GuideUpload> decode_guide_query(const Query& query) { return decode_query<GuideUpload>(query); }

Result<EnvironmentUpload> decode_environment_query(const Query& query) {
  return decode_query<EnvironmentUpload>(query);
}

Result<std::pair<std::uint64_t, std::uint64_t>> decode_compare_query(const Query& query) {
  const auto revisions = decode_query<json_parts::Revisions>(query);
  if (!revisions) return revisions.status();
  return std::pair(revisions->from, revisions->to);
}

Result<std::optional<std::uint64_t>> decode_revision_query(const Query& query) {
  const auto at = decode_query<json_parts::AtRevision>(query);
  if (!at) return at.status();
  return at->revision;
}

}  // namespace pelage
