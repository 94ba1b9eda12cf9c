#include "protocol/json/decode.h"

#include <algorithm>
#include <string>

#include "protocol/base/limits.h"
#include "protocol/json/decode_parts.h"
#include "protocol/json/decode_tools.h"
#include "protocol/json/parse.h"

namespace pelage {

namespace {

using namespace json_parts;

/// Parses the text, lets `read` make something of the tree, and gives that or the first refusal.
template <class T, class Read>
Result<T> decode_document(std::string_view text, Read read) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  Status first_failure;
  T result = read(Value(*tree, "", first_failure));
  if (!first_failure.ok()) return first_failure;
  return result;
}

Command set_coat(Object& object) {
  SetCoat result;
  object.required("coat", [&](const Value& v) { result.coat = coat(v); });
  return result;
}

Command set_look(Object& object) {
  SetLook result;
  object.required("look", [&](const Value& v) { result.look = look(v); });
  return result;
}

Command set_lights(Object& object) {
  SetLights result;
  object.required("lights", [&](const Value& list) {
    for (const Value& member : list.list(0, limits::lights)) result.lights.push_back(light(member));
  });
  return result;
}

Command set_environment(Object& object) {
  SetEnvironment result;
  object.required("environment", [&](const Value& v) { result.environment = environment(v); });
  return result;
}

Command set_ground(Object& object) {
  SetGround result;
  object.required("ground", [&](const Value& v) { result.ground = ground(v); });
  return result;
}

Command set_eyes(Object& object) {
  SetEyes result;
  object.required("eyes", [&](const Value& list) {
    for (const Value& member : list.list(0, limits::eyes)) result.eyes.push_back(eye(member));
  });
  return result;
}

Command set_curves(Object& object) {
  SetCurves result;
  object.required("groups", [&](const Value& list) { result.groups = curve_groups(list); });
  return result;
}

Command set_skin(Object& object) {
  SetSkin result;
  object.required("regions", [&](const Value& list) {
    for (const Value& member : list.list(0, limits::skin_regions)) result.regions.push_back(skin_region(member));
  });
  return result;
}

Command set_base_picture(Object& object) {
  SetBasePicture result;
  object.required("picture", [&](const Value& v) {
    if (v.tree() != "own") result.picture = picture_name(v, "own, or 32 hex digits in lower case");
  });
  return result;
}

/// The readers of all commands by their names.
const std::vector<NamedReader>& command_readers() {
  static const std::vector<NamedReader> readers = [] {
    std::vector<NamedReader> all = tool_readers();
    all.insert(all.end(), {{"set_coat", set_coat},
                           {"set_look", set_look},
                           {"set_lights", set_lights},
                           {"set_environment", set_environment},
                           {"set_ground", set_ground},
                           {"set_eyes", set_eyes},
                           {"set_curves", set_curves},
                           {"set_skin", set_skin},
                           {"set_base_picture", set_base_picture}});
    return all;
  }();
  return readers;
}

Command command(const Value& value) {
  Object object(value);
  CommandReader read = nullptr;
  object.required("op", [&](const Value& v) {
    std::vector<std::string_view> known;
    for (const NamedReader& reader : command_readers()) known.push_back(reader.name);
    const std::string word = v.word_of(known);
    for (const NamedReader& reader : command_readers()) {
      if (reader.name == word) read = reader.read;
    }
  });
  if (!read || !value.fine()) return {};
  Command result = read(object);
  object.finish();
  return result;
}

void background(const Value& value, FrameRequest& result) {
  const nlohmann::json& tree = value.tree();
  result.background = tree == "transparent" ? Background::transparent
                      : tree == "studio"    ? Background::studio
                                            : Background::colour;
  if (result.background == Background::colour) result.background_colour = value.colour();
}

std::vector<FrameLayer> layers(const Value& list) {
  std::vector<FrameLayer> result;
  for (const Value& member : list.list(1, json_names::frame_layers.size())) {
    const FrameLayer layer = member.name_of(json_names::frame_layers);
    if (std::find(result.begin(), result.end(), layer) != result.end()) {
      member.refuse("The layer is named twice.", "each layer once");
    }
    result.push_back(layer);
  }
  return result;
}

void refine(const Value& value, FrameRequest& result) {
  if (value.tree().is_object()) {
    result.refine = tracing(value);
  } else if (value.boolean()) {
    result.refine = Tracing{};
  }
}

/// What shells draw and strands do not.
void check_strands(const Value& value, const FrameRequest& request) {
  const bool strands = request.knobs.method == Method::strands;
  if (strands && request.refine) {
    value.refuse_below("refine", "Strands refine what shells have drawn.", "a quality of shells");
  }
  const Overlay overlay = request.overlay;
  const bool of_shells = overlay == Overlay::layer_count || overlay == Overlay::light_depth ||
                         overlay == Overlay::light_occlusion || overlay == Overlay::shadow_width;
  if ((strands || request.refine) && of_shells) {
    value.refuse_below("overlay", "Traced strands have no such map.", "a field, or method shells without refine");
  }
}

/// Knobs are named, or chosen by what they may cost, or by how far they may be off.
void check_dial(const Value& value, Object& object, const FrameRequest& request) {
  const bool two_goals = request.budget_ms && request.max_error;
  if (two_goals || (request.plans() && object.has("quality"))) {
    value.refuse_below(request.max_error ? "max_error" : "budget_ms", "One of them chooses the quality.",
                       "one of quality, budget_ms and max_error");
  }
}

/// Which members do not go together.
void check_frame(const Value& value, const FrameRequest& request, bool names_layers) {
  check_strands(value, request);
  const double width = request.width * request.knobs.scale, height = request.height * request.knobs.scale;
  if (std::max(width, height) > limits::frame_pixels) {
    value.refuse_below("quality", "The quality's scale renders the frame too large.",
                       "scale x width and scale x height at most " + std::to_string(limits::frame_pixels));
  }
  const bool sorted = request.knobs.order == FragmentOrder::sorted;
  if (sorted && width * height * request.knobs.shells > limits::sorted_fragments) {
    value.refuse_below("quality", "The frame is too large to be sorted.",
                       "drawn pixels x shells at most " + std::to_string(limits::sorted_fragments));
  }
  const bool exr = request.format == FrameFormat::exr;
  if (names_layers && !exr) value.refuse_below("layers", "Only an EXR has layers.", "format exr");
  const bool colour_only = request.layers == std::vector{FrameLayer::beauty};
  if (exr && !colour_only && width * height * static_cast<double>(request.layers.size()) > limits::layer_pixels) {
    value.refuse_below("layers", "The layers are too large together.",
                       "drawn pixels x layers at most " + std::to_string(limits::layer_pixels));
  }
  if (exr && request.overlay != Overlay::none) {
    value.refuse_below("overlay", "An EXR has no overlay.", "format png, png16 or jpeg");
  }
  const bool compares = request.overlay == Overlay::difference;
  if (compares && !request.overlay_from) {
    value.refuse_below("overlay_from", "A picture of a difference needs the revision to compare with.", "required");
  }
  if (!compares && request.overlay_from) {
    value.refuse_below("overlay_from", "Only a picture of a difference compares.", "overlay difference");
  }
  if (request.format == FrameFormat::jpeg && request.background == Background::transparent) {
    value.refuse_below("background", "JPEG has no alpha.", "a colour or studio");
  }
}

FrameRequest frame_request(const Value& value) {
  Object object(value);
  FrameRequest result;
  object.integer("width", result.width, pixels);
  object.integer("height", result.height, pixels);
  object.optional("camera", [&](const Value& v) { result.camera = camera(v); });
  object.optional("quality", [&](const Value& v) { result.knobs = quality(v); });
  object.optional("budget_ms", [&](const Value& v) { result.budget_ms = v.number(budget_ms); });
  object.optional("max_error", [&](const Value& v) { result.max_error = v.number(max_error); });
  object.optional("background", [&](const Value& v) { background(v, result); });
  object.number("exposure", result.exposure, {-20, 20});
  object.name("tone_map", result.tone_map, json_names::tone_maps);
  object.optional("look", [&](const Value& v) { result.look = look(v); });
  object.optional("view", [&](const Value& v) { result.view = v.text(0, limits::name_bytes); });
  object.name("format", result.format, json_names::frame_formats);
  object.integer("jpeg_quality", result.jpeg_quality, {1, 100});
  object.name("exr_type", result.exr_type, json_names::exr_types);
  object.optional("layers", [&](const Value& v) { result.layers = layers(v); });
  object.name("overlay", result.overlay, json_names::overlays);
  object.optional("overlay_from", [&](const Value& v) { result.overlay_from = v.counter(); });
  object.optional("refine", [&](const Value& v) { refine(v, result); });
  object.finish();
  check_dial(value, object, result);
  check_frame(value, result, object.has("layers"));
  return result;
}

}  // namespace

Result<std::vector<Command>> decode_commands(std::string_view text) {
  return decode_document<std::vector<Command>>(text, [](const Value& value) {
    std::vector<Command> commands;
    if (!value.tree().is_object() || !value.tree().contains("commands")) {
      commands.push_back(command(value));
      return commands;
    }
    Object object(value);
    object.required("commands", [&](const Value& list) {
      for (const Value& member : list.list(1, limits::commands_per_batch)) commands.push_back(command(member));
    });
    object.finish();
    return commands;
  });
}

Result<NewScene> decode_new_scene(std::string_view text) {
  return decode_document<NewScene>(text, [](const Value& value) {
    Object object(value);
    NewScene result;
    object.optional("name", [&](const Value& v) { result.name = v.text(1, limits::name_bytes); });
    object.optional("model", [&](const Value& v) {
      Object model(v);
      model.name("builtin", result.model.shape, json_names::builtins);
      model.integer("triangles", result.model.triangles, {2, static_cast<double>(limits::builtin_triangles)});
      model.finish();
    });
    object.optional("fur", [&](const Value& v) { result.fur = fur(v); });
    object.name("fur_patches", result.fur_patches, json_names::fur_patches);
    object.finish();
    return result;
  });
}

Result<FrameRequest> decode_frame_request(std::string_view text) {
  return decode_document<FrameRequest>(text, frame_request);
}

Result<PickRequest> decode_pick(std::string_view text) {
  return decode_document<PickRequest>(text, [](const Value& value) {
    Object object(value);
    PickRequest result;
    object.optional("view", [&](const Value& v) { result.view = view(v); });
    object.required("pixel", [&](const Value& v) {
      const std::vector<Value> parts = v.list(2, 2);
      if (parts.empty()) return;
      result.pixel = {parts[0].number({0, static_cast<double>(result.view.width)}),
                      parts[1].number({0, static_cast<double>(result.view.height)})};
    });
    object.finish();
    return result;
  });
}

Result<int> decode_steps(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return 1;
  return decode_document<int>(text, [](const Value& value) {
    Object object(value);
    int steps = 1;
    object.integer("steps", steps, {1, 1e6});
    object.finish();
    return steps;
  });
}

Result<Subdivide> decode_subdivide(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return Subdivide{};
  return decode_document<Subdivide>(text, [](const Value& value) {
    Object object(value);
    Subdivide result;
    object.integer("levels", result.levels, {1, limits::subdivide_levels});
    object.boolean("masked", result.masked);
    object.finish();
    return result;
  });
}

Result<BranchRequest> decode_branch(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return BranchRequest{};
  return decode_document<BranchRequest>(text, [](const Value& value) {
    Object object(value);
    BranchRequest result;
    object.optional("name", [&](const Value& v) { result.name = v.text(1, limits::name_bytes); });
    object.optional("revision", [&](const Value& v) { result.revision = v.counter(); });
    object.finish();
    return result;
  });
}

Result<AmendRequest> decode_amend(std::string_view text) {
  return decode_document<AmendRequest>(text, [](const Value& value) {
    Object object(value);
    AmendRequest result;
    object.required("revision", [&](const Value& v) { result.revision = v.counter(); });
    object.required("commands", [&](const Value& list) {
      for (const Value& member : list.list(0, limits::commands_per_batch)) result.commands.push_back(command(member));
    });
    object.finish();
    return result;
  });
}

Result<std::uint64_t> decode_revision(std::string_view text) {
  return decode_document<std::uint64_t>(text, [](const Value& value) {
    Object object(value);
    std::uint64_t revision = 0;
    object.required("revision", [&](const Value& v) { revision = v.counter(); });
    object.finish();
    return revision;
  });
}

}  // namespace pelage
