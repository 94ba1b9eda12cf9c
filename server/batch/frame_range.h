// Ranges of frames, such as "1-100x5".
#pragma once

#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

/// Parts with commas between them: `7`, `1-100`, `1-100x5` or `1-100:5` (a step), each end in [-1000000, 1000000]; the
/// numbers as they are written. Refused (invalid): what is none of these, a range that goes down, a frame that is named
/// twice, more than 1,000,000 frames.
Result<std::vector<int>> parse_frames(std::string_view text);

}  // namespace pelage
