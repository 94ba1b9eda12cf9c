// Parses ranges of frames, such as "1-100x5".
#pragma once

#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

/// Parses parts that are separated by commas: `7`, `1-100`, `1-100x5` or `1-100:5` (with a step), with ends in
/// [-1000000, 1000000]. Returns the numbers in the given order. Refused (invalid): any other text, a descending range,
/// a frame that occurs twice, more than 1,000,000 frames.
Result<std::vector<int>> parse_frames(std::string_view text);

}  // namespace pelage
