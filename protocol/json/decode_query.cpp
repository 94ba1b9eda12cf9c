// Query parameters become the JSON document that they stand for, so that one decoder refuses what is wrong with them.
#include <array>
#include <sstream>

#include "protocol/json/decode.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/nearest.h"
#include "protocol/json/parse.h"
#include "protocol/json/read.h"

namespace pelage {

namespace {

using nlohmann::json;

enum class Kind { text, number, list, names, boolean };  // lists and names have commas

/// A parameter, and the JSON pointer of what it stands for.
struct Parameter {
  std::string_view name;
  const char* pointer;
  Kind kind;
};

constexpr auto frame_parameters = std::to_array<Parameter>({
    {"width", "/width", Kind::number},
    {"height", "/height", Kind::number},
    {"camera", "/camera/auto", Kind::text},
    {"position", "/camera/position", Kind::list},
    {"target", "/camera/target", Kind::list},
    {"up", "/camera/up", Kind::list},
    {"fov_degrees", "/camera/fov_degrees", Kind::number},
    {"quality", "/quality", Kind::text},
    {"shells", "/quality/shells", Kind::number},
    {"steps", "/quality/steps", Kind::number},
    {"scale", "/quality/scale", Kind::number},
    {"min_radius", "/quality/min_radius", Kind::number},
    {"eye_steps", "/quality/eye_steps", Kind::number},
    {"self_shadow", "/quality/self_shadow", Kind::boolean},
    {"shadow_maps", "/quality/shadow_maps", Kind::boolean},
    {"shadow_resolution", "/quality/shadow_resolution", Kind::number},
    {"shell_policy", "/quality/shell_policy", Kind::text},
    {"order", "/quality/order", Kind::text},
    {"fins", "/quality/fins", Kind::boolean},
    {"guard_hairs", "/quality/guard_hairs", Kind::number},
    {"method", "/quality/method", Kind::text},
    {"budget_ms", "/budget_ms", Kind::number},
    {"max_error", "/max_error", Kind::number},
    {"background", "/background", Kind::text},
    {"exposure", "/exposure", Kind::number},
    {"tone_map", "/tone_map", Kind::text},
    {"view", "/view", Kind::text},
    {"format", "/format", Kind::text},
    {"jpeg_quality", "/jpeg_quality", Kind::number},
    {"exr_type", "/exr_type", Kind::text},
    {"aovs", "/aovs", Kind::names},
    {"overlay", "/overlay", Kind::text},
    {"overlay_from", "/overlay_from", Kind::number},
    {"colour_source", "/look/colour_source", Kind::text},
});

constexpr auto tracing_parameters = std::to_array<Parameter>({
    {"passes", "/passes", Kind::number},
    {"transport", "/transport", Kind::text},
    {"scattering", "/scattering", Kind::text},
    {"bounces", "/bounces", Kind::number},
    {"strands", "/strands", Kind::number},
    {"noise", "/noise", Kind::number},
    {"seconds", "/seconds", Kind::number},
    {"filter", "/filter", Kind::boolean},
    {"seed", "/seed", Kind::number},
});

constexpr auto import_parameters = std::to_array<Parameter>({
    {"format", "/format", Kind::text},
    {"up", "/up", Kind::text},
    {"front", "/front", Kind::text},
    {"length", "/length", Kind::number},
    {"inclination", "/inclination", Kind::number},
    {"form", "/form", Kind::text},
    {"fur_patches", "/fur_patches", Kind::text},
});

constexpr auto environment_parameters = std::to_array<Parameter>({
    {"intensity", "/intensity", Kind::number},
    {"turn_degrees", "/turn_degrees", Kind::number},
});

constexpr auto compare_parameters = std::to_array<Parameter>({
    {"from", "/from", Kind::number},
    {"to", "/to", Kind::number},
});

constexpr auto map_parameters = std::to_array<Parameter>({
    {"field", "/field", Kind::text},
    {"format", "/format", Kind::text},
    {"encoding", "/encoding", Kind::text},
    {"size", "/size", Kind::number},
    {"dilate", "/dilate", Kind::number},
    {"scale", "/scale", Kind::number},
    {"units", "/units", Kind::text},
});

constexpr auto map_upload_parameters = std::to_array<Parameter>({
    {"field", "/field", Kind::text},
    {"encoding", "/encoding", Kind::text},
    {"scale", "/scale", Kind::number},
    {"units", "/units", Kind::text},
    {"strength", "/strength", Kind::number},
});

json names_of(const std::string& text) {
  json names = json::array();
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

/// What is no number, list or truth value stays text, and the decoder says what it expected.
json value_of(const std::string& text, Kind kind) {
  if (kind == Kind::text) return text;
  if (kind == Kind::names) return names_of(text);
  if (kind == Kind::list && text.find_first_not_of("0123456789+-.eE, ") != std::string::npos) return text;
  json value = json::parse(kind == Kind::list ? "[" + text + "]" : text, nullptr, false);
  const bool fits = kind == Kind::number ? value.is_number()
                    : kind == Kind::list ? value.is_array()
                                         : value.is_boolean();
  return fits ? value : json(text);
}

bool is_utf8(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)) == text;
}

Status place(json& document, const Parameter& parameter, const std::string& text) {
  const json::json_pointer pointer(parameter.pointer);
  json& parent = document[pointer.parent_pointer()];
  const bool knobs_and_tier = parent.is_string() || (document.contains(pointer) && document[pointer].is_object());
  if (knobs_and_tier) {
    return failure(Code::invalid, "A tier and single knobs exclude each other.", "/quality", "a tier or knobs");
  }
  if (document.contains(pointer)) {
    return failure(Code::malformed, "The parameter \"" + std::string(parameter.name) + "\" is given twice.",
                   parameter.pointer, "each name once");
  }
  document[pointer] = value_of(text, parameter.kind);
  return {};
}

/// The document that the parameters stand for.
template <std::size_t N>
Result<json> document_of(const Query& query, const std::array<Parameter, N>& parameters) {
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
    if (Status status = place(document, *found, text); !status.ok()) return status;
  }
  return document;
}

template <class T, std::size_t N>
Result<T> decode_query(const Query& query, const std::array<Parameter, N>& parameters) {
  const auto document = document_of(query, parameters);
  if (!document) return document.status();
  Status first_failure;
  T result = json_parts::read<T>(Value(*document, "", first_failure));
  if (!first_failure.ok()) return first_failure;
  return result;
}

}  // namespace

Result<FrameRequest> decode_frame_query(const Query& query) {
  return decode_query<FrameRequest>(query, frame_parameters);
}

Result<Tracing> decode_tracing_query(const Query& query) { return decode_query<Tracing>(query, tracing_parameters); }

Result<ImportOptions> decode_import_query(const Query& query) {
  return decode_query<ImportOptions>(query, import_parameters);
}

Result<MapRequest> decode_map_query(const Query& query) { return decode_query<MapRequest>(query, map_parameters); }

Result<MapUpload> decode_map_upload_query(const Query& query) {
  return decode_query<MapUpload>(query, map_upload_parameters);
}

Result<Environment> decode_environment_query(const Query& query) {
  const auto upload = decode_query<json_parts::EnvironmentUpload>(query, environment_parameters);
  if (!upload) return upload.status();
  return upload->environment;
}

Result<std::pair<std::uint64_t, std::uint64_t>> decode_compare_query(const Query& query) {
  const auto revisions = decode_query<json_parts::Revisions>(query, compare_parameters);
  if (!revisions) return revisions.status();
  return std::pair(revisions->from, revisions->to);
}

}  // namespace pelage
