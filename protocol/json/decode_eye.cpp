// The blocks of an eye.
#include "protocol/json/decode_parts.h"

namespace pelage::json_parts {

namespace {

constexpr Range signed_degrees{-90, 90};

Iris iris(const Value& value) {
  Object object(value);
  Iris result;
  object.colour("colour", result.colour);
  object.colour("inner_colour", result.inner_colour);
  object.number("size", result.size, {0.1, 0.95});
  object.number("depth", result.depth, {0, 0.5});
  object.number("relief", result.relief, {0, 0.2});
  object.number("limbal_ring", result.limbal_ring, share);
  object.number("turn_degrees", result.turn_degrees, {-360, 360});
  object.finish();
  return result;
}

Pupil pupil(const Value& value) {
  Object object(value);
  Pupil result;
  object.name("shape", result.shape, json_names::pupil_shapes);
  object.optional("size", [&](const Value& v) {
    if (v.tree().is_string() && v.tree() == "automatic") return;
    if (!v.tree().is_number()) return v.refuse("A number or \"automatic\" is expected.", "automatic | [0, 1]");
    result.size = v.number(share);
  });
  object.finish();
  return result;
}

Lids lids(const Value& value) {
  Object object(value);
  Lids result;
  object.optional("facing", [&](const Value& v) { result.facing = v.direction(); });
  object.number("width_degrees", result.width_degrees, {1, 90});
  object.number("upper_degrees", result.upper_degrees, signed_degrees);
  object.number("lower_degrees", result.lower_degrees, signed_degrees);
  object.number("tilt_degrees", result.tilt_degrees, {-180, 180});
  object.colour("colour", result.colour);
  object.finish();
  return result;
}

void look(Object& object, Eye& result) {
  const bool has_gaze = object.has("gaze");
  object.optional("gaze", [&](const Value& v) { result.gaze = v.direction(); });
  object.optional("look_at", [&](const Value& v) { result.look_at = v.triple(coordinate); });
  if (!result.look_at) return;
  if (has_gaze) object.value().refuse_below("gaze", "An eye takes a gaze or a point to look at.", "gaze | look_at");
  if (*result.look_at == result.position) {
    object.value().refuse_below("look_at", "The eye cannot look at its own centre.", "differs from position");
  }
}

}  // namespace

Eye eye(const Value& value) {
  Object object(value);
  Eye result;
  object.required("position", [&](const Value& v) { result.position = v.triple(coordinate); });
  object.required("radius", [&](const Value& v) { result.radius = v.number({limits::least_eye_radius, 1e6}); });
  look(object, result);
  object.optional("iris", [&](const Value& v) { result.iris = iris(v); });
  object.optional("pupil", [&](const Value& v) { result.pupil = pupil(v); });
  object.optional("lids", [&](const Value& v) { result.lids = lids(v); });
  object.colour("sclera", result.sclera);
  object.number("bulge", result.bulge, share);
  object.number("refraction", result.refraction, {1, 3});
  object.number("wetness", result.wetness, share);
  object.finish();
  return result;
}

}  // namespace pelage::json_parts
