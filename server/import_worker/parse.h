// From the bytes of a file to polygons. Runs in the confined worker only.
#pragma once

#include <limits>
#include <string>

#include "protocol/base/status.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Reads `bytes` as `format` and as nothing else. Refused (invalid) with the reason when they are broken, cut off,
/// or ask for files or extensions that are not there. Opens no file.
Result<RawModel> parse_model(ModelFormat format, std::string bytes);

/// What a file does not say of a vertex.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// One for each reader.
Result<RawModel> parse_obj(std::string text);
Result<RawModel> parse_ply(const std::string& bytes);
Result<RawModel> parse_stl(const std::string& bytes);
Result<RawModel> parse_off(const std::string& text);
/// glTF, GLB and 3DS.
Result<RawModel> parse_with_assimp(ModelFormat format, const std::string& bytes);

/// The refusal of a broken file.
inline Status broken(std::string reason) { return failure(Code::invalid, std::move(reason)); }

}  // namespace pelage
