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
    if (!std::all_of(curves[i].begin(), curves[i].end(), is_finite))
      return broken_guides("a number of curve " + std::to_string(i) + " is not finite.");
  }
  return {};
}

Result<GuideFile> read(GuideFormat format, std::string_view bytes) {
  if (format == GuideFormat::usda) return read_usda_curves(bytes);
  Result<std::vector<GuideCurve>> curves =
      format == GuideFormat::hair ? read_hair_curves(bytes) : read_json_curves(bytes);
  return curves ? Result<GuideFile>(GuideFile{std::move(*curves)}) : curves.status();
}

}  // namespace

Result<GuideFile> read_guides(GuideFormat format, std::string_view bytes) {
  Result<GuideFile> file = read(format, bytes);
  if (!file) return file;
  if (Status status = check(file->curves); !status.ok()) return status;
  file->single = std::erase_if(file->curves, [](const GuideCurve& curve) { return curve.size() < 2; });
  if (file->curves.empty()) return broken_guides("each of its curves has fewer than two points.");
  return file;
}

}  // namespace pelage
