#include "protocol/json/decode_parts.h"

namespace pelage::json_parts {

namespace {

std::vector<RampStop> ramp(const Value& list) {
  std::vector<RampStop> result;
  for (const Value& stop : list.list(1, limits::ramp_stops)) {
    Object fields(stop);
    RampStop made;
    fields.required("at", [&](const Value& v) { made.at = v.number(share); });
    fields.required("colour", [&](const Value& v) { made.colour = v.colour(); });
    fields.finish();
    if (!result.empty() && !(made.at > result.back().at)) {
      stop.refuse_below("at", "The ramp does not rise.", "above the stop before");
    }
    result.push_back(made);
  }
  return result;
}

Undercoat undercoat(const Value& value) {
  Object object(value);
  Undercoat result;
  object.number("share", result.share, share);
  object.number("length", result.length, {0.02, 1});
  object.number("width", result.width, {0.05, 4});
  object.number("lightness", result.lightness, {0, 4});
  object.number("tint", result.tint, share);
  object.colour("colour", result.colour);
  object.finish();
  return result;
}

OddHairs odd_hairs(const Value& value) {
  Object object(value);
  OddHairs result;
  object.number("share", result.share, share);
  object.colour("colour", result.colour);
  object.finish();
  return result;
}

Tufts tufts(const Value& value) {
  Object object(value);
  Tufts result;
  object.number("gather", result.gather, share);
  object.number("size", result.size, {0.01, 1});
  object.integer("scales", result.scales, {1, 3});
  object.integer("seed", result.seed);
  object.finish();
  return result;
}

Pattern pattern(const Value& value) {
  Object object(value);
  Pattern result;
  object.name("kind", result.kind, json_names::pattern_kinds);
  object.number("scale", result.scale, feature_size);
  object.number("coverage", result.coverage, share);
  object.number("contrast", result.contrast, share);
  object.number("softness", result.softness, share);
  object.number("warp", result.warp, {0, 2});
  object.number("legs", result.legs, share);
  object.number("inner", result.inner, share);
  object.number("belly", result.belly, share);
  object.optional("axis", [&](const Value& v) { result.axis = v.direction(); });
  object.colour("colour", result.colour);
  object.colour("inner_colour", result.inner_colour);
  object.colour("belly_colour", result.belly_colour);
  object.integer("seed", result.seed);
  object.finish();
  return result;
}

Variation variation(const Value& value) {
  Object object(value);
  Variation result;
  object.number("lightness", result.lightness, share);
  object.number("hue", result.hue, share);
  object.number("length", result.length, share);
  object.number("lean", result.lean, share);
  object.number("size", result.size, feature_size);
  object.finish();
  return result;
}

void forms(Object& object, Coat& result) {
  object.number("bend", result.bend, {0, 2});
  object.number("curl", result.curl, {0, 0.5});
  object.number("curl_turns", result.curl_turns, {0, 20});
  object.number("curl_together", result.curl_together, share);
  object.number("wave", result.wave, {0, 0.5});
  object.number("wave_turns", result.wave_turns, {0, 20});
  object.number("mess", result.mess, share);
  object.number("clump", result.clump, share);
  object.number("clump_size", result.clump_size, clump_size);
  object.number("fine_clump", result.fine_clump, share);
  object.number("fine_clump_size", result.fine_clump_size, clump_size);
  object.number("lodge", result.lodge, share);
  object.number("lodge_size", result.lodge_size, clump_size);
  object.number("wetness", result.wetness, share);
}

}  // namespace

Coat coat(const Value& value) {
  Object object(value);
  Coat result;
  object.integer("count", result.count, {1, 100000});
  object.number("tile", result.tile, {0.01, 1});
  object.number("width_root", result.width_root, {0, 0.05});
  object.number("width_tip", result.width_tip, {0, 0.05});
  forms(object, result);
  object.number("length_spread", result.length_spread, share);
  object.number("colour_spread", result.colour_spread, share);
  object.number("root_share", result.root_share, share);
  object.name("lean_curve", result.lean_curve, json_names::lean_curves);
  object.optional("ramp", [&](const Value& v) { result.ramp = ramp(v); });
  object.optional("undercoat", [&](const Value& v) { result.undercoat = undercoat(v); });
  object.optional("odd_hairs", [&](const Value& v) { result.odd_hairs = odd_hairs(v); });
  object.optional("tufts", [&](const Value& v) { result.tufts = tufts(v); });
  object.optional("pattern", [&](const Value& v) { result.pattern = pattern(v); });
  object.optional("variation", [&](const Value& v) { result.variation = variation(v); });
  object.integer("seed", result.seed);
  object.finish();
  return result;
}

}  // namespace pelage::json_parts
