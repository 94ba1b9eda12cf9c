// Files of guide curves that other programs made. Anybody may have written them: read in the confined worker only.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/guides.h"

namespace pelage {

/// What a file holds. Refused (invalid), saying where: what is cut off or is no such file, a number that is not finite,
/// and a file without curves of two points. `usda`: all BasisCurves of USD as text, where their Xforms put them;
/// control points of cubic ones count as points. `hair`: HAIR (cyHair). `json`: {"curves": [[[x, y, z], ...], ...]}.
Result<GuideFile> read_guides(GuideFormat format, std::string_view bytes);

Result<GuideFile> read_usda_curves(std::string_view text);
Result<std::vector<GuideCurve>> read_hair_curves(std::string_view bytes);
Result<std::vector<GuideCurve>> read_json_curves(std::string_view text);

/// A refusal of a file: the reason alone.
inline Status broken_guides(std::string why) { return failure(Code::invalid, std::move(why)); }

}  // namespace pelage
