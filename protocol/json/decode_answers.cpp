#include "protocol/json/decode_answers.h"

#include <charconv>

#include "protocol/json/names.h"
#include "protocol/json/parse.h"

namespace pelage {

namespace {

using nlohmann::json;

constexpr const char* unknown_answer = "The server's answer is not what this client knows.";

/// Reads a tree with nlohmann's own checks of types; a miss is a refusal of the whole answer.
template <class T, class Read>
Result<T> decode_document(std::string_view text, Read read) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  try {
    return read(*tree);
  } catch (const json::exception&) {
    return failure(Code::malformed, unknown_answer);
  }
}

glm::dvec3 triple(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

FieldsHash hash_of(const std::string& text) {
  FieldsHash hash;
  if (text.size() != 32) return hash;
  std::from_chars(text.data(), text.data() + 16, hash.high, 16);
  std::from_chars(text.data() + 16, text.data() + 32, hash.low, 16);
  return hash;
}

CommandResult result_of(const json& value) {
  CommandResult result{.op = value.at("op"),
                       .touched = value.at("touched"),
                       .mean_change = value.at("mean_change"),
                       .max_change = value.at("max_change"),
                       .clamped = value.at("clamped"),
                       .milliseconds = value.at("milliseconds"),
                       .warnings = value.at("warnings")};
  for (const json& field : value.at("fields")) {
    result.fields.push_back({.field = field.at("field"),
                             .changed = field.at("changed"),
                             .mean_change = field.at("mean_change"),
                             .max_change = field.at("max_change")});
  }
  return result;
}

SceneSummary summary_of(const json& value) {
  ModelReport report{.source_vertices = value.at("source_vertices"),
                     .source_faces = value.at("source_faces"),
                     .vertices = value.at("vertices"),
                     .triangles = value.at("triangles"),
                     .parts = value.at("parts"),
                     .size = value.at("size"),
                     .min = triple(value.at("bounds").at("min")),
                     .max = triple(value.at("bounds").at("max")),
                     .repairs = {}};
  for (const json& repair : value.at("repairs")) report.repairs.push_back({repair.at("code"), repair.at("count")});
  std::vector<EditLayer> layers;
  for (const json& layer : value.at("edit_layers"))
    layers.push_back({.name = layer.at("name"), .weight = layer.at("weight"), .muted = layer.at("muted")});
  return {.id = value.at("id"),
          .name = value.at("name"),
          .revision = value.at("revision"),
          .model = value.at("model"),
          .fur_patches = value.at("fur_patches"),
          .report = report,
          .fields_hash = hash_of(value.at("fields_hash")),
          .undo_steps = value.at("undo_steps"),
          .redo_steps = value.at("redo_steps"),
          .edit_layers = layers};
}

Code code_of(const std::string& type) {
  static constexpr std::pair<std::string_view, Code> codes[] = {
      {"malformed", Code::malformed},       {"not-found", Code::not_found},
      {"conflict", Code::conflict},         {"too-large", Code::too_large},
      {"precondition", Code::precondition}, {"unsupported", Code::unsupported},
      {"invalid", Code::invalid},           {"busy", Code::busy},
      {"unavailable", Code::unavailable}};
  for (const auto& [name, code] : codes) {
    if (type == "urn:pelage:problem:" + std::string(name)) return code;
  }
  return Code::internal;
}

}  // namespace

Result<CommandAnswer> decode_command_answer(std::string_view text) {
  return decode_document<CommandAnswer>(text, [](const json& value) {
    CommandAnswer answer{
        .revision = value.at("revision"), .fields_hash = hash_of(value.at("fields_hash")), .results = {}};
    for (const json& result : value.at("results")) answer.results.push_back(result_of(result));
    return answer;
  });
}

Result<SceneSummary> decode_scene_summary(std::string_view text) {
  return decode_document<SceneSummary>(text, summary_of);
}

Result<std::vector<SceneSummary>> decode_scene_list(std::string_view text) {
  return decode_document<std::vector<SceneSummary>>(text, [](const json& value) {
    std::vector<SceneSummary> summaries;
    for (const json& scene : value.at("scenes")) summaries.push_back(summary_of(scene));
    return summaries;
  });
}

static auto painted_of(const json& value) {
  decltype(PickAnswer::painted) painted{};
  for (std::size_t i = 0; i < painted.size(); ++i) {
    const json& field = value.at(std::string(field_shapes[first_painted + i].name));
    if (field.is_number()) painted[i].x = field;
    for (std::size_t k = 0; field.is_array() && k < 4; ++k) painted[i][static_cast<int>(k)] = field.at(k);
  }
  return painted;
}

Result<PickAnswer> decode_pick_answer(std::string_view text) {
  return decode_document<PickAnswer>(text, [](const json& value) {
    if (!value.at("hit").get<bool>()) return PickAnswer{};
    return PickAnswer{.hit = true,
                      .triangle = value.at("triangle"),
                      .barycentric = triple(value.at("barycentric")),
                      .position = triple(value.at("position")),
                      .normal = triple(value.at("normal")),
                      .direction = triple(value.at("direction")),
                      .inclination = value.at("inclination"),
                      .length = value.at("length"),
                      .stretch = value.at("stretch"),
                      .painted = painted_of(value.at("painted"))};
  });
}

Result<PictureAnswer> decode_picture_answer(std::string_view text) {
  return decode_document<PictureAnswer>(text, [](const json& value) {
    PictureAnswer answer{.picture = value.at("picture"),
                         .width = value.at("width"),
                         .height = value.at("height"),
                         .bits = value.at("bits"),
                         .scale = {}};
    if (value.contains("scale")) answer.scale = value.at("scale").get<double>();
    return answer;
  });
}

Result<std::vector<LogEntry>> decode_log(std::string_view text) {
  return decode_document<std::vector<LogEntry>>(text, [](const json& value) {
    std::vector<LogEntry> log;
    for (const json& entry : value.at("entries")) {
      log.push_back({.revision = entry.at("revision"),
                     .kind = entry.at("kind"),
                     .commands = entry.contains("commands") ? entry.at("commands").dump() : std::string(),
                     .touched = entry.at("touched"),
                     .in_effect = entry.at("in_effect")});
    }
    return log;
  });
}

Result<TraceReport> decode_trace_report(std::string_view text) {
  return decode_document<TraceReport>(text, [](const json& value) {
    TraceReport report{.passes = value.at("passes"),
                       .samples = value.at("samples"),
                       .noise = value.at("noise"),
                       .strands = value.at("strands"),
                       .grow_ms = value.at("grow_ms"),
                       .trace_ms = value.at("trace_ms")};
    const std::string end = value.at("end");
    for (const auto& known : json_names::trace_ends) {
      if (known.text == end) report.end = known.value;
    }
    return report;
  });
}

Status decode_problem(std::string_view text) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  try {
    return {.code = code_of(tree->at("type")),
            .message = tree->at("detail"),
            .pointer = tree->value("pointer", ""),
            .limit = tree->value("limit", ""),
            .nearest = tree->value("nearest", "")};
  } catch (const json::exception&) {
    return failure(Code::malformed, unknown_answer);
  }
}

}  // namespace pelage
