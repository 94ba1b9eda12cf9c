#include "protocol/json/encode.h"
#include "protocol/json/names.h"
#include "protocol/json/write.h"

namespace pelage {

namespace {

using json_names::text_of;
using json_parts::Json;
using json_parts::line;

Json list(glm::dvec3 v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const std::vector<FieldChange>& changes) {
  Json fields = Json::array();
  for (const FieldChange& change : changes) {
    fields.push_back({{"field", change.field},
                      {"changed", change.changed},
                      {"mean_change", change.mean_change},
                      {"max_change", change.max_change}});
  }
  return fields;
}

Json json_of(const CommandResult& result) {
  return {{"op", result.op},
          {"touched", result.touched},
          {"mean_change", result.mean_change},
          {"max_change", result.max_change},
          {"clamped", result.clamped},
          {"milliseconds", result.milliseconds},
          {"fields", json_of(result.fields)},
          {"warnings", result.warnings}};
}

Json json_of(const SceneSummary& summary) {
  const ModelReport& report = summary.report;
  Json repairs = Json::array();
  for (const Repair& repair : report.repairs) repairs.push_back({{"code", repair.code}, {"count", repair.count}});
  Json layers = Json::array();
  for (const EditLayer& layer : summary.edit_layers)
    layers.push_back({{"name", layer.name}, {"weight", layer.weight}, {"muted", layer.muted}});
  return {{"id", summary.id},
          {"name", summary.name},
          {"revision", summary.revision},
          {"model", summary.model},
          {"fur_patches", summary.fur_patches},
          {"source_vertices", report.source_vertices},
          {"source_faces", report.source_faces},
          {"vertices", report.vertices},
          {"triangles", report.triangles},
          {"parts", report.parts},
          {"size", report.size},
          {"bounds", {{"min", list(report.min)}, {"max", list(report.max)}}},
          {"repairs", repairs},
          {"fields_hash", to_hex(summary.fields_hash)},
          {"undo_steps", summary.undo_steps},
          {"redo_steps", summary.redo_steps},
          {"edit_layers", layers}};
}

/// RFC 9457's `type` and `title`. Refusals of HTTP itself have no type of their own but the status.
struct Problem {
  const char* type;
  const char* title;
};

Problem problem_of(Code code) {
  switch (code) {
    case Code::malformed: return {"urn:pelage:problem:malformed", "The request cannot be read"};
    case Code::not_found: return {"urn:pelage:problem:not-found", "There is nothing of that name"};
    case Code::conflict: return {"urn:pelage:problem:conflict", "The request is at odds with another"};
    case Code::precondition: return {"urn:pelage:problem:precondition", "The scene is at another revision"};
    case Code::too_large: return {"urn:pelage:problem:too-large", "The body is too large"};
    case Code::unsupported: return {"urn:pelage:problem:unsupported", "The body has a form that is not read here"};
    case Code::invalid: return {"urn:pelage:problem:invalid", "The request breaks the contract"};
    case Code::busy: return {"urn:pelage:problem:busy", "Too much is going on"};
    case Code::unavailable: return {"urn:pelage:problem:unavailable", "Not possible now"};
    case Code::ok:
    case Code::internal: break;
  }
  return {"urn:pelage:problem:internal", "The server failed"};
}

Problem problem_of(const Status& status, int http_status) {
  switch (http_status) {
    case 401: return {"about:blank", "Unauthorized"};
    case 403: return {"about:blank", "Forbidden"};
    case 405: return {"about:blank", "Method Not Allowed"};
    case 411: return {"about:blank", "Length Required"};
    case 416: return {"about:blank", "Range Not Satisfiable"};
    default: return problem_of(status.code);
  }
}

}  // namespace

std::string encode(const CommandAnswer& answer) {
  Json results = Json::array();
  for (const CommandResult& result : answer.results) results.push_back(json_of(result));
  return line({{"revision", answer.revision}, {"fields_hash", to_hex(answer.fields_hash)}, {"results", results}});
}

std::string encode(const SceneSummary& summary) { return line(json_of(summary)); }

std::string encode(const std::vector<SceneSummary>& summaries) {
  Json scenes = Json::array();
  for (const SceneSummary& summary : summaries) scenes.push_back(json_of(summary));
  return line({{"scenes", scenes}});
}

static Json painted_of(const PickAnswer& answer) {
  Json painted = Json::object();
  for (std::size_t i = 0; i < answer.painted.size(); ++i) {
    const FieldShape& shape = field_shapes[first_painted + i];
    const glm::dvec4 value = answer.painted[i];
    painted[std::string(shape.name)] =
        shape.channels == 1 ? Json(value.x) : Json::array({value.x, value.y, value.z, value.w});
  }
  return painted;
}

std::string encode(const PickAnswer& answer) {
  if (!answer.hit) return line({{"hit", false}});
  return line({{"hit", true},
               {"triangle", answer.triangle},
               {"barycentric", list(answer.barycentric)},
               {"position", list(answer.position)},
               {"normal", list(answer.normal)},
               {"direction", list(answer.direction)},
               {"inclination", answer.inclination},
               {"length", answer.length},
               {"stretch", answer.stretch},
               {"painted", painted_of(answer)}});
}

std::string encode(const Comparison& comparison) {
  return line({{"from", comparison.from},
               {"to", comparison.to},
               {"touched", comparison.touched},
               {"fields", json_of(comparison.fields)}});
}

std::string encode(const FoldCount& folds) {
  return line({{"revision", folds.revision}, {"triangles", folds.triangles}, {"folded", folds.folded}});
}

std::string encode(const std::vector<LogEntry>& log) {
  Json entries = Json::array();
  for (const LogEntry& entry : log) {
    Json json = {
        {"revision", entry.revision}, {"kind", entry.kind}, {"touched", entry.touched}, {"in_effect", entry.in_effect}};
    if (!entry.commands.empty()) json["commands"] = Json::parse(entry.commands, nullptr, false);
    entries.push_back(std::move(json));
  }
  return line({{"entries", entries}});
}

std::string encode_problem(const Status& status, int http_status) {
  const Problem problem = problem_of(status, http_status);
  Json json = {{"type", problem.type}, {"title", problem.title}, {"status", http_status}, {"detail", status.message}};
  if (!status.pointer.empty() || http_status == 422) json["pointer"] = status.pointer;
  if (!status.limit.empty()) json["limit"] = status.limit;
  if (!status.nearest.empty()) json["nearest"] = status.nearest;
  return line(json);
}

/// Before it can be estimated noise is infinite, which JSON cannot say; no shown channel is further off than 1.
std::string encode(const TraceReport& report) {
  return line({{"passes", report.passes},
               {"samples", report.samples},
               {"noise", report.noise < 1 ? report.noise : 1},
               {"strands", report.strands},
               {"end", text_of(json_names::trace_ends, report.end)},
               {"grow_ms", report.grow_ms},
               {"trace_ms", report.trace_ms}});
}

std::string encode(const FrameEstimate& estimate) {
  return line({{"error", estimate.error},
               {"error_safety", estimate.error_safety},
               {"measured", estimate.measured},
               {"reference", "sorted_shells"},
               {"cost_ms", estimate.cost_ms},
               {"cost_safety", estimate.cost_safety},
               {"correction", estimate.correction},
               {"end", text_of(json_names::plan_ends, estimate.end)},
               {"calibration", estimate.calibration}});
}

std::string encode(const FrameCounters& counters) {
  return line({{"passes", counters.passes},
               {"draws", counters.draws},
               {"textures", counters.textures},
               {"bytes", counters.bytes},
               {"fragments", counters.fragments},
               {"objects", counters.objects},
               {"allocated", counters.allocated},
               {"redrawn", counters.redrawn}});
}

std::string encode(const MapAnswer& answer) {
  const Json json = {{"revision", answer.revision},
                     {"field", shape_of(answer.field).name},
                     {"encoding", text_of(json_names::map_encodings, answer.encoding)},
                     {"scale", answer.scale},
                     {"units", text_of(json_names::units, answer.units)},
                     {"covered", answer.covered},
                     {"outside", answer.outside}};
  return line(json);
}

std::string encode(const PictureAnswer& answer) {
  Json json = {{"picture", answer.picture}, {"width", answer.width}, {"height", answer.height}, {"bits", answer.bits}};
  if (answer.scale) json["scale"] = *answer.scale;
  return line(json);
}

}  // namespace pelage
