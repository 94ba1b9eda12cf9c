// The blocks of guided curves.
#include "protocol/json/decode_parts.h"

namespace pelage::json_parts {

namespace {

constexpr Range width{0, 0.1};

GuideCurve guide(const Value& list) {
  GuideCurve points;
  for (const Value& point : list.list(2, limits::curve_points)) points.push_back(point.triple(coordinate));
  return points;
}

}  // namespace

CurveGroup curve_group(const Value& value) {
  Object object(value);
  CurveGroup result;
  object.required("curves", [&](const Value& list) {
    for (const Value& curve : list.list(1, limits::curves)) result.curves.push_back(guide(curve));
  });
  object.number("width_root", result.width_root, width);
  object.number("width_tip", result.width_tip, width);
  object.colour("root_colour", result.root_colour);
  object.colour("tip_colour", result.tip_colour);
  object.integer("fill", result.fill, {0, limits::curves - 1});
  object.number("spread", result.spread, share);
  object.integer("seed", result.seed);
  object.finish();
  return result;
}

std::vector<CurveGroup> curve_groups(const Value& list) {
  std::vector<CurveGroup> result;
  std::uint64_t count = 0;
  for (const Value& member : list.list(0, limits::curve_groups)) {
    count += curve_count(result.emplace_back(curve_group(member)));
    if (count > limits::curves) {
      member.refuse("These are too many curves.", "at most " + std::to_string(limits::curves) + " in all groups");
    }
  }
  return result;
}

}  // namespace pelage::json_parts
