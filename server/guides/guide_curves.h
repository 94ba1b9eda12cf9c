// Guide curves that other programs made: the files that bring them.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/guides.h"

namespace pelage {

/// At least two points, root first.
using GuideCurve = std::vector<glm::dvec3>;

/// The curves of a file, in its coordinates. Refused (invalid), saying where: what is cut off or is no such file, a
/// number that is not finite, a curve of one point, and a file without curves.
/// `usda`: all BasisCurves of USD as text, where their Xforms put them; control points of cubic ones count as points.
/// `hair`: HAIR (cyHair). `json`: {"curves": [[[x, y, z], ...], ...]}.
Result<std::vector<GuideCurve>> read_guides(GuideFormat format, std::string_view bytes);

Result<std::vector<GuideCurve>> read_usda_curves(std::string_view text);
Result<std::vector<GuideCurve>> read_hair_curves(std::string_view bytes);
Result<std::vector<GuideCurve>> read_json_curves(std::string_view text);

/// A refusal of a file.
inline Status broken_guides(const std::string& why) {
  return failure(Code::invalid, "The file cannot be read: " + why);
}

}  // namespace pelage
