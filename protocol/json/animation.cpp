#include "protocol/json/animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "protocol/json/key_curve.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

using json_parts::KeyCurve;
using nlohmann::json;

/// A part of the settings, the command that sets it, and the command's member that holds it.
struct Section {
  std::string_view name, op, member;
};
constexpr std::array<Section, 9> sections{{{"coats", "set_coats", "coats"},
                                           {"look", "set_look", "look"},
                                           {"lights", "set_lights", "lights"},
                                           {"environment", "set_environment", "environment"},
                                           {"ground", "set_ground", "ground"},
                                           {"wind", "set_wind", "wind"},
                                           {"eyes", "set_eyes", "eyes"},
                                           {"curves", "set_curves", "groups"},
                                           {"skin", "set_skin", "regions"}}};
constexpr std::string_view frame_section = "frame";

std::string section_of(const std::string& parameter) {
  if (parameter.empty() || parameter.front() != '/') return {};
  return parameter.substr(1, parameter.find('/', 1) - 1);
}

const Section* find_section(const std::string& name) {
  const auto found = std::ranges::find(sections, name, &Section::name);
  return found == sections.end() ? nullptr : found;
}

Status unknown_section(const std::string& name, const std::string& pointer) {
  std::vector<std::string_view> known{frame_section};
  for (const Section& section : sections) known.push_back(section.name);
  std::string limit;
  for (const std::string_view word : known) limit += (limit.empty() ? "/" : ", /") + std::string(word);
  return failure(Code::invalid, "No such part of a scene can be animated.", pointer, limit, nearest_name(name, known));
}

json command_of(const Section& section, const json& value) { return {{"op", section.op}, {section.member, value}}; }

/// Changes the pointer of a refusal from the command's member to the parameter.
Status in_section(Status status, const Section* section) {
  if (!section) status.pointer = "/frame" + status.pointer;
  if (section)
    status.pointer.replace(0, std::min(section->member.size() + 1, status.pointer.size()),
                           "/" + std::string(section->name));
  return status;
}
template <class T>
Status status_of(const Result<T>& result) {
  return result ? Status{} : result.status();
}

Status at_frame(Status status, double frame) {
  std::string number = json(frame).dump();
  if (frame == std::floor(frame)) number = std::to_string(static_cast<std::int64_t>(frame));
  status.message = "At frame " + number + ": " + status.message;
  return status;
}

/// Returns a crop as large as the largest tile of a frame; null if the frame has a crop already, or no valid size.
json crop_of_tiles(const json& frame, const TileGrid& tiles) {
  if (!frame.is_object() || frame.contains("crop")) return nullptr;
  const json width = frame.value("width", json(FrameRequest().width));
  const json height = frame.value("height", json(FrameRequest().height));
  if (!width.is_number() || !height.is_number()) return nullptr;
  return {{"left", 0},
          {"top", 0},
          {"width", std::ceil(width.get<double>() / tiles.columns)},
          {"height", std::ceil(height.get<double>() / tiles.rows)}};
}

}  // namespace

struct Animation::Impl {
  json document;  // "frame", and the sections of the settings
  std::optional<TileGrid> tiles;
  std::map<std::string, std::vector<std::pair<json::json_pointer, KeyCurve>>> curves;  // by section

  Status add(const ParameterKeys& keys, const std::string& pointer, bool time_lapse);
  bool takes(const std::string& parameter, const json::json_pointer& path, const json& value) const;
};

/// Returns whether the contract accepts this value of the parameter; refusals of other members do not count.
bool Animation::Impl::takes(const std::string& parameter, const json::json_pointer& path, const json& value) const {
  json changed = document;
  changed[path] = value;
  const std::string name = section_of(parameter);
  const Section* section = find_section(name);
  const auto refusal = [&]() -> Status {
    if (!section) return status_of(decode_frame_request(changed[name].dump()));
    return status_of(decode_commands(command_of(*section, changed[name]).dump()));
  };
  return in_section(refusal(), section).pointer != parameter;
}

Status Animation::Impl::add(const ParameterKeys& keys, const std::string& pointer, bool time_lapse) {
  const std::string parameter = pointer + "/parameter", section = section_of(keys.parameter);
  if (section != frame_section && !find_section(section)) return unknown_section(section, parameter);
  if (section != frame_section && time_lapse)
    return failure(Code::invalid, "A time lapse shows each revision with its own settings.", parameter, "/frame/...");
  json::json_pointer path;
  try {
    path = json::json_pointer(keys.parameter);
    // A frame request leaves out members at their default, so only its decoder can tell whether a member exists.
    if (path.empty() || path == json::json_pointer("/" + section)) throw std::invalid_argument("a whole part");
    if (section != frame_section) static_cast<void>(document.at(path));
    json copy = document;
    if (section == frame_section) copy[path] = nullptr;
  } catch (const std::exception&) {
    return failure(Code::invalid, "The scene has no such parameter.", parameter, "as /lights/0/intensity");
  }
  Result<KeyCurve> curve = KeyCurve::create(keys, pointer);
  if (!curve) return curve.status();
  const std::optional<json> between = curve->between_integer_keys();
  if (between && takes(keys.parameter, path, curve->first()) && !takes(keys.parameter, path, *between))
    curve->round_values();
  curves[section].emplace_back(std::move(path), std::move(curve).value());
  return {};
}

Result<Animation> Animation::create(const RenderJob& job, const SceneSettings& settings) {
  auto impl = std::make_shared<Impl>();
  impl->document = json::parse(encode(SettingsAnswer{.settings = settings}));
  impl->tiles = job.tiles;
  json& frame = impl->document[frame_section] = json::parse(job.frame);
  if (frame.is_object() && job.output.ends_with(".exr") && !frame.contains("format")) frame["format"] = "exr";
  for (std::size_t k = 0; k < job.keyframes.size(); ++k) {
    const Status added = impl->add(job.keyframes[k], "/keyframes/" + std::to_string(k), job.time_lapse);
    if (!added.ok()) return added;
  }
  return Animation(std::move(impl));
}

bool Animation::limits_seconds() const { return impl_->document.at(frame_section).contains("max_seconds"); }

Result<AnimatedFrame> Animation::at(double frame) const {
  json document = impl_->document;
  for (const auto& [name, curves] : impl_->curves)
    for (const auto& [path, curve] : curves) document[path] = curve.at(frame);
  // Limits apply to what is drawn at once, which is a tile.
  const json tile = impl_->tiles ? crop_of_tiles(document[frame_section], *impl_->tiles) : nullptr;
  if (!tile.is_null()) document[frame_section]["crop"] = tile;
  Result<FrameRequest> request = decode_frame_request(document[frame_section].dump());
  if (request && !tile.is_null()) request->crop.reset();
  if (!request) {
    const Status refused = in_section(request.status(), nullptr);
    return impl_->curves.contains(std::string(frame_section)) ? at_frame(refused, frame) : refused;
  }
  AnimatedFrame result{.request = std::move(request).value(), .settings = {}};
  for (const auto& [name, curves] : impl_->curves) {
    if (name == frame_section) continue;
    const Section* section = find_section(name);
    const auto command = decode_commands(command_of(*section, document[name]).dump());
    if (!command) return at_frame(in_section(command.status(), section), frame);
    result.settings.push_back(command->front());
  }
  return result;
}

}  // namespace pelage
