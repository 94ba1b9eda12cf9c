// The parsers of model formats (OBJ, PLY, STL, OFF, and others through assimp), what they share, and whether the
// build runs under a sanitizer, which needs more address space and more system calls than we allow.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

class Bundle;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif
#else
inline constexpr bool is_sanitized = false;
#endif

// Numbers, words and lines of text formats. Numbers are rounded correctly to double, whatever the locale.

/// Parses the whole word as a number with an optional sign, also "nan" and "inf". Overflow gives infinity, underflow 0.
std::optional<double> to_number(std::string_view word);

/// Removes the next word, which ends at a blank or line end, from the text and returns it; empty at the end.
std::string_view take_word(std::string_view& text);

/// Removes the next line, which ends with LF, CR or both, from the text and returns it.
std::string_view take_line(std::string_view& text);

// Parsing the bytes of a file to polygons. Runs in the confined worker only.

/// Parses `bytes` as `format` and as nothing else. Refused (invalid) with the reason if they are broken, cut off, or
/// need missing files or unknown extensions. Opens no file. `pose` is that of ImportOptions; refused if the format has
/// no animations. Without `pictures` the model has no images.
Result<RawModel> parse_model(ModelFormat format, std::string bytes, const std::string& pose = {}, bool pictures = true);

/// Marks a number of a vertex that the file does not give.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Returns the texture coordinates that a file gives; non-finite ones stay distinct from missing ones.
inline glm::dvec2 given_uv(double u, double v) {
  return is_finite({u, v, 0}) ? glm::dvec2(u, v) : glm::dvec2(std::numeric_limits<double>::infinity());
}

// The parsers of the formats.
Result<RawModel> parse_obj(Bundle& bundle);
Result<RawModel> parse_ply(const std::string& bytes);
Result<RawModel> parse_stl(const std::string& bytes);
Result<RawModel> parse_off(const std::string& text);
/// Parses glTF, GLB and 3DS.
Result<RawModel> parse_with_assimp(ModelFormat format, Bundle& bundle, const std::string& pose);

/// Returns the refusal (invalid) of a broken file.
inline Status broken(std::string reason) { return failure(Code::invalid, std::move(reason)); }

}  // namespace pelage
