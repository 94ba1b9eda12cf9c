#include "server/guide_files/read_guides.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pelage {

namespace {

bool is_finite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Status check(const std::vector<GuideCurve>& curves) {
  if (curves.empty()) return broken_guides("it has no curves.");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].size() < 2) return broken_guides("curve " + std::to_string(i) + " has fewer than two points.");
    if (!std::all_of(curves[i].begin(), curves[i].end(), is_finite))
      return broken_guides("a number of curve " + std::to_string(i) + " is not finite.");
  }
  return {};
}

Result<std::vector<GuideCurve>> read(GuideFormat format, std::string_view bytes) {
  switch (format) {
    case GuideFormat::usda: return read_usda_curves(bytes);
    case GuideFormat::hair: return read_hair_curves(bytes);
    default: return read_json_curves(bytes);
  }
}

}  // namespace

Result<std::vector<GuideCurve>> read_guides(GuideFormat format, std::string_view bytes) {
  Result<std::vector<GuideCurve>> curves = read(format, bytes);
  if (!curves) return curves;
  if (Status status = check(*curves); !status.ok()) return status;
  return curves;
}

}  // namespace pelage
