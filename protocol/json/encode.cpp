#include "protocol/json/encode.h"

#include <nlohmann/json.hpp>

#include "protocol/json/encode_parts.h"
#include "protocol/json/encode_tools.h"
#include "protocol/json/names.h"

namespace pelage {

namespace {

using namespace json_parts;
using json_names::text_of;

std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void add_members(Json& json, const SetCoat& command) { json["coat"] = json_of(command.coat); }

void add_members(Json& json, const SetLook& command) { json["look"] = json_of(command.look); }

void add_members(Json& json, const SetLights& command) {
  json["lights"] = Json::array();
  for (const Light& light : command.lights) json["lights"].push_back(json_of(light));
}

void add_members(Json& json, const SetEnvironment& command) { json["environment"] = json_of(command.environment); }

void add_members(Json& json, const SetGround& command) { json["ground"] = json_of(command.ground); }

void add_members(Json& json, const SetEyes& command) {
  json["eyes"] = Json::array();
  for (const Eye& eye : command.eyes) json["eyes"].push_back(json_of(eye));
}

void add_members(Json& json, const SetCurves& command) {
  json["groups"] = Json::array();
  for (const CurveGroup& group : command.groups) json["groups"].push_back(json_of(group));
}

void add_members(Json& json, const SetSkin& command) {
  json["regions"] = Json::array();
  for (const SkinRegion& region : command.regions) json["regions"].push_back(json_of(region));
}

void add_members(Json& json, const SetBasePicture& command) {
  json["picture"] = command.picture.empty() ? "own" : command.picture;
}

Json json_of(const Command& command) {
  Json json = {{"op", op_of(command)}};
  if (add_tool_members(json, command)) return json;
  std::visit(
      [&](const auto& c) {
        if constexpr (requires { add_members(json, c); }) add_members(json, c);
      },
      command);
  return json;
}

Json json_of(const Tracing& trace) {
  Json json = {{"passes", trace.passes},
               {"transport", text_of(json_names::transports, trace.transport)},
               {"scattering", text_of(json_names::strand_scatterings, trace.scattering)},
               {"strands", trace.strands},
               {"noise", trace.noise},
               {"seconds", trace.seconds},
               {"filter", trace.filter},
               {"seed", trace.seed}};
  if (trace.transport == Transport::paths) json["bounces"] = trace.bounces;
  return json;
}

/// What the method uses: the others are refused beside it.
Json json_of(const Knobs& knobs) {
  if (knobs.method == Method::strands) {
    return {{"method", text_of(json_names::methods, knobs.method)},
            {"eye_steps", knobs.eye_steps},
            {"guard_hairs", knobs.guard_hairs},
            {"trace", json_of(knobs.trace)}};
  }
  return {{"shells", knobs.shells},
          {"steps", knobs.steps},
          {"scale", knobs.scale},
          {"least_radius", knobs.least_radius},
          {"eye_steps", knobs.eye_steps},
          {"self_shadow", knobs.self_shadow},
          {"shadow_maps", knobs.shadow_maps},
          {"shadow_resolution", knobs.shadow_resolution},
          {"fins", knobs.fins},
          {"guard_hairs", knobs.guard_hairs},
          {"shell_policy", text_of(json_names::shell_policies, knobs.shell_policy)},
          {"order", text_of(json_names::fragment_orders, knobs.order)}};
}

}  // namespace

std::string encode(const Command& command) { return line(json_of(command)); }

std::string encode(const std::vector<Command>& commands) {
  if (commands.size() == 1) return encode(commands.front());
  Json json = {{"commands", Json::array()}};
  for (const Command& command : commands) json["commands"].push_back(json_of(command));
  return line(json);
}

std::string encode(const NewScene& request) {
  const Json model = {{"builtin", text_of(json_names::builtins, request.model.shape)},
                      {"triangles", request.model.triangles}};
  const Json fur = {{"length", request.fur.length}, {"inclination", request.fur.inclination},
                    {"form", text_of(json_names::groom_forms, request.fur.form)}};
  return line({{"name", request.name},
               {"model", model},
               {"fur", fur},
               {"fur_patches", text_of(json_names::fur_patches, request.fur_patches)}});
}

std::string encode(const FrameRequest& request) {
  Json json = {{"width", request.width},
               {"height", request.height},
               {"camera", json_of(request.camera)},
               {"background", request.background == Background::studio ? "studio" : "transparent"},
               {"exposure", request.exposure},
               {"tone_map", text_of(json_names::tone_maps, request.tone_map)},
               {"format", text_of(json_names::frame_formats, request.format)},
               {"jpeg_quality", request.jpeg_quality},
               {"exr_type", text_of(json_names::exr_types, request.exr_type)},
               {"overlay", text_of(json_names::overlays, request.overlay)}};
  if (!request.plans()) json["quality"] = json_of(request.knobs);
  if (request.budget_ms) json["budget_ms"] = *request.budget_ms;
  if (request.max_error) json["max_error"] = *request.max_error;
  if (request.format == FrameFormat::exr) json["layers"] = list(request.layers);
  if (request.background == Background::colour) json["background"] = colour(request.background_colour);
  if (request.look) json["look"] = json_of(*request.look);
  if (!request.view.empty()) json["view"] = request.view;
  if (request.overlay_from) json["overlay_from"] = *request.overlay_from;
  if (request.refine) json["refine"] = json_of(*request.refine);
  return line(json);
}

std::string encode(const BranchRequest& request) {
  Json json = {{"name", request.name}};
  if (request.revision) json["revision"] = *request.revision;
  return line(json);
}

std::string encode(const AmendRequest& request) {
  Json commands = Json::array();
  for (const Command& command : request.commands) commands.push_back(json_of(command));
  return line({{"revision", request.revision}, {"commands", commands}});
}

std::string encode(const PickRequest& request) {
  return line({{"view", json_of(request.view)}, {"pixel", list(request.pixel)}});
}

std::string json_text(std::string_view text) { return line(Json(text)); }

std::string encode(const Knobs& knobs) { return line(json_of(knobs)); }

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

}  // namespace pelage
