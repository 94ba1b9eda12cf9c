// The blocks of a region of bare skin.
#include "protocol/json/decode_parts.h"

namespace pelage::json_parts {

namespace {

SkinFacing facing(const Value& value) {
  Object object(value);
  SkinFacing result;
  object.required("direction", [&](const Value& v) { result.direction = v.direction(); });
  object.number("angle_degrees", result.angle_degrees, {0, 180});
  object.number("fade_degrees", result.fade_degrees, {0, 180});
  object.finish();
  return result;
}

SkinBumps bumps(const Value& value) {
  Object object(value);
  SkinBumps result;
  object.number("height", result.height, {0, 0.1});
  object.number("size", result.size, {1e-4, 1});
  object.finish();
  return result;
}

}  // namespace

SkinRegion skin_region(const Value& value) {
  Object object(value);
  SkinRegion result;
  object.required("centre", [&](const Value& v) { result.centre = v.triple(coordinate); });
  object.required("radii", [&](const Value& v) { result.radii = v.triple({limits::least_skin_radius, 1e6}); });
  object.optional("axis", [&](const Value& v) { result.axis = v.direction(); });
  object.number("turn_degrees", result.turn_degrees, {-180, 180});
  object.number("softness", result.softness, {0, 10});
  object.optional("facing", [&](const Value& v) { result.facing = facing(v); });
  object.colour("colour", result.colour);
  object.number("shine", result.shine, share);
  object.number("roughness", result.roughness, {0.02, 1});
  object.number("wetness", result.wetness, share);
  object.number("scatter", result.scatter, share);
  object.optional("bumps", [&](const Value& v) { result.bumps = bumps(v); });
  object.finish();
  return result;
}

}  // namespace pelage::json_parts
