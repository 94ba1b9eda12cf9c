// Reads files of guide curves from other programs. They are untrusted, and read in the confined worker only.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/guides.h"

namespace pelage {

/// Returns the curves of a file. Refused (invalid), with the reason: a file that is cut off or of another format, a
/// number that is not finite, and a file without curves of two points. `usda`: all BasisCurves of USD as text,
/// transformed by their Xforms; control points of cubic curves count as points. `hair`: HAIR (cyHair). `json`:
/// {"curves": [[[x, y, z], ...], ...]}.
Result<GuideFile> read_guides(GuideFormat format, std::string_view bytes);

Result<GuideFile> read_usda_curves(std::string_view text);
Result<std::vector<GuideCurve>> read_hair_curves(std::string_view bytes);
Result<std::vector<GuideCurve>> read_json_curves(std::string_view text);

/// Returns the refusal (invalid) of a file; its message is only the reason.
inline Status broken_guides(std::string why) { return failure(Code::invalid, std::move(why)); }

}  // namespace pelage
