#include <string>

#include "protocol/json/parse.h"
#include "server/guide_files/read_guides.h"

namespace pelage {

namespace {

using nlohmann::json;

bool is_point(const json& value) {
  return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
}

}  // namespace

Result<std::vector<GuideCurve>> read_json_curves(std::string_view text) {
  const Result<json> root = parse_json(text);
  if (!root) return broken_guides("its JSON is broken: " + root.status().message);
  if (!root->is_object() || !root->contains("curves") || !(*root)["curves"].is_array())
    return broken_guides("it is no {\"curves\": [[[x, y, z], ...], ...]}.");
  std::vector<GuideCurve> curves;
  for (const json& points : (*root)["curves"]) {
    GuideCurve& curve = curves.emplace_back();
    const std::string name = "curve " + std::to_string(curves.size() - 1);
    if (!points.is_array()) return broken_guides(name + " is no list of points.");
    for (const json& point : points) {
      if (!is_point(point)) return broken_guides("a point of " + name + " is not three numbers.");
      curve.emplace_back(point[0].get<double>(), point[1].get<double>(), point[2].get<double>());
    }
  }
  return curves;
}

}  // namespace pelage
