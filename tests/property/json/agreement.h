// Adjusts random members so that they go together, as the rules of protocol/json/rules.h require.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/property/json/generators.h"

namespace pelage::testing {

template <class T>
void fit(T&) {}
inline void fit(Comb& comb) {
  comb.direction.reset();
  if (comb.flood) comb.direction = direction();
}
inline void fit(Interpolate& command) {
  for (Key& key : command.keys) {
    if (!key.direction) key.inclination.reset();
    if (!key.direction && !key.length) key.length = 0.5;
  }
}
inline void fit(Unify& unify) {
  const auto drop = [&](Field field) { std::erase(unify.mean, field); };
  if (unify.direction || unify.inclination) drop(Field::direction);
  if (unify.length) drop(Field::length);
  if (!unify.direction && !unify.inclination && !unify.length && unify.mean.empty()) unify.inclination = 0.5;
}
inline void fit(Length& length) {
  if (length.mode != LengthMode::add) length.value = std::abs(length.value);
  if (length.mode == LengthMode::jitter) length.value = number(0, 1);
}
inline void fit(Erase& erase) {
  if (!erase.checkpoint.empty()) erase.revision.reset();
}
inline void fit(Paint& paint) {
  paint.field = field_at(static_cast<std::size_t>(*rc::gen::inRange(3, static_cast<int>(field_count))));
  paint.value = number(0, shape_of(paint.field).max);
  if (shape_of(paint.field).channels == 1) paint.colour = glm::vec3(1);
}
inline void fit(ChangeMask& mask) {
  if (auto* box = std::get_if<MaskBox>(&mask.shape)) box->max = glm::max(box->min, box->max);
}
inline void fit(ApplyMap& map) {
  if (map.tile < first_udim || map.encoding == MapEncoding::vertices) map.tile = 0;
  if (!fits(map.field, map.encoding)) map.encoding = MapEncoding::automatic;
}
template <class T>
void rename(std::vector<T>& named) {
  for (std::size_t k = 0; k < named.size(); ++k) named[k].name = std::to_string(k);
}
inline void fit(SetBlowers& command) { rename(command.blowers); }
inline void fit(SetAttractors& command) { rename(command.attractors); }

inline void fit(SetCoats& command) {
  for (std::size_t k = 0; k < command.coats.size(); ++k) {
    command.coats[k].name = std::to_string(k), command.coats[k].id = k;
    command.coats[k].muted = command.coats[k].muted && k > 0;
  }
}
inline void fit(ChangeEditLayer& layer) {
  if (layer.action == EditLayerAction::set && !layer.weight && !layer.muted && layer.rename.empty()) layer.muted = true;
  if (layer.action == EditLayerAction::move && !layer.above) layer.above = "";
  if (layer.above == layer.name) layer.above = "";
}

inline void fit(SetCurves& command) {
  std::uint64_t count = 0;
  for (CurveGroup& group : command.groups) {
    if (count + curve_count(group) > limits::curves) group.fill = 0;
    count += curve_count(group);
  }
}
inline void fit(Coat& coat) {
  for (std::size_t i = 0; i < coat.ramp.size(); ++i)
    coat.ramp[i].at = 0.25 * static_cast<double>(i) + number(0.01, 0.2);
}
inline void fit(Environment& environment) {
  if (environment.harmonics) {
    environment.sky = environment.horizon = environment.ground = glm::vec3(1);
  } else {
    environment.turn_degrees = 0;
  }
}
inline void fit(Eye& eye) {
  if (eye.look_at) eye.look_at->x = eye.position.x > 0 ? -1 : 1;
}
inline void fit(Brush& brush) {
  brush.strand_from /= 2, brush.strand_to = 0.6 + 0.4 * brush.strand_to;
  if (brush.reach == Reach::fur) brush.falloff_shape = FalloffShape::volume;
}
inline void fit(Stroke& stroke) {
  if (!stroke.view) stroke.view.emplace();
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].time = static_cast<double>(i) + number(0, 0.5);
}
inline void fit(Tracing& tracing) {
  if (tracing.transport == Transport::paths) tracing.scattering = StrandScattering::energy_conserving;
}
inline void fit(Layering& shells) {
  if (shells.order == FragmentOrder::sorted) shells.count = std::min(shells.count, 128);
}
inline void fit(MapAnswer& map) { map.encoding = encoding_of(map.field, map.encoding); }
inline void fit(PictureAnswer& picture) { picture.bits = picture.bits < 16 ? 8 : picture.bits < 32 ? 16 : 32; }
inline void fit(FrameRequest& frame) {
  frame.knobs.scale = std::min(frame.knobs.scale, 8192.0 / std::max(frame.width, frame.height));
  if (frame.knobs.scale < 0.25) frame.knobs.scale = 0.25;
  if (frame.budget_ms) frame.max_error.reset();
  if (frame.plans()) frame.knobs = {};
  if (frame.knobs.shells.order == FragmentOrder::sorted) frame.height = std::min(frame.height, 512);
  if (frame.crop) {
    Crop& crop = *frame.crop;
    crop.left = std::min(crop.left, frame.width - 1), crop.width = std::min(crop.width, frame.width - crop.left);
    crop.top = std::min(crop.top, frame.height - 1), crop.height = std::min(crop.height, frame.height - crop.top);
  }
  if (is_linear(frame.format)) {
    frame.overlay = Overlay::none;
    if (frame.aovs.size() > 1) frame.aovs.resize(1);
  }
  if (frame.format == FrameFormat::jpeg) frame.background = Background::studio;
  if (frame.knobs.method != Method::raster) frame.progressive.reset();
  if (frame.knobs.method == Method::shells) frame.overlay = Overlay::none, frame.aovs = {Aov::beauty};
  if (frame.revision) frame.progressive.reset();
  if (frame.overlay != Overlay::difference) frame.overlay_from.reset();
  if (frame.overlay == Overlay::difference && !frame.overlay_from) frame.overlay_from = 3;
}

// Some tools cannot be inverted, and only colours differ from root to tip.
template <class Tool>
void agree_with_brush(Tool& tool) {
  constexpr bool no_opposite = std::is_same_v<Tool, Smooth> || std::is_same_v<Tool, Unify> ||
                               std::is_same_v<Tool, Erase> || std::is_same_v<Tool, Trim> ||
                               std::is_same_v<Tool, Interpolate> || std::is_same_v<Tool, Flow>;
  if constexpr (no_opposite) tool.brush.invert = false;
  if constexpr (std::is_same_v<Tool, Paint>) {
    if (shape_of(tool.field).channels == 4) return;
  }
  tool.brush.strand_from = 0, tool.brush.strand_to = 1;
}

// The mask is not part of any edit layer.
template <class Tool>
void agree_with_edit_layer(Tool& tool) {
  bool mask = false;
  const auto has = [](const std::vector<Field>& fields) {
    return std::count(fields.begin(), fields.end(), Field::mask) > 0;
  };
  if constexpr (requires { tool.field; }) mask = tool.field == Field::mask;
  if constexpr (requires { tool.fields; }) mask = has(tool.fields);
  if constexpr (requires { tool.mean; }) mask = has(tool.mean);
  if (mask) tool.edit_layer.clear();
}

// No coat is named twice.
template <class Tool>
void agree_with_coats(Tool& tool) {
  if (tool.coats.size() > limits::coats) tool.coats.resize(limits::coats);
  for (std::size_t k = 0; k < tool.coats.size(); ++k) tool.coats[k] = std::to_string(k) + tool.coats[k];
}

/// Adjusts a struct to its own rules, and to those of a tool with a brush if it is one.
template <class T>
void agree(T& value) {
  if constexpr (requires { value.flood; }) {
    value.stroke.reset();
    if (!value.flood) value.stroke = random_stroke();
  }
  fit(value);
  if constexpr (requires { value.brush; }) agree_with_brush(value);
  if constexpr (requires { value.edit_layer; }) agree_with_edit_layer(value), agree_with_coats(value);
}

}  // namespace pelage::testing
